#pragma once

#include <string>
#include <vector>

#include "interpreter/points.hpp"

namespace treeline::interpreter {

/// A rigid grasp of an object: the hand on its robot, and the pose of the object in the hand.
template <class Scalar>
struct Grasp {
  int robot = 0;
  OperationalPoint<Scalar> point;                   ///< the hand; `axes` and `rows` are not used
  Matrix3<Scalar> R = Matrix3<Scalar>::Identity();  ///< rotation of the object's frame in the
                                                    ///< point's
  Vector3<Scalar> p = Vector3<Scalar>::Zero();      ///< origin of the object's frame in the point's
};

/// A rigid body that one or several hands hold. It has no coordinates of its own: its pose and
/// velocity are those that its first grasp gives it.
template <class Scalar>
struct GraspedObject {
  std::string name;
  Scalar mass = Scalar(0);
  Vector3<Scalar> com = Vector3<Scalar>::Zero();      ///< in the object's frame
  Matrix3<Scalar> inertia = Matrix3<Scalar>::Zero();  ///< about `com`, object's axes
  std::vector<Grasp<Scalar>> grasps;                  ///< at least one
};

/// Robots and the objects that they hold: a simple closed chain (Chang 7.2). Without the objects it
/// has no loops.
template <class Scalar>
struct ClosedChain {
  std::vector<Model<Scalar>> robots;
  std::vector<GraspedObject<Scalar>> objects;
};

/// Converts a chain to another precision.
template <class To, class From>
ClosedChain<To> cast(const ClosedChain<From>& chain) {
  const auto to = [](const From& x) { return static_cast<To>(x); };
  ClosedChain<To> result;
  for (const auto& robot : chain.robots) result.robots.push_back(cast<To>(robot));
  for (const auto& from : chain.objects) {
    GraspedObject<To> object{
        from.name, to(from.mass), from.com.unaryExpr(to), from.inertia.unaryExpr(to), {}};
    for (const auto& grasp : from.grasps) {
      object.grasps.push_back({grasp.robot, cast<To>(Points<From>{grasp.point}).front(),
                               grasp.R.unaryExpr(to), grasp.p.unaryExpr(to)});
    }
    result.objects.push_back(std::move(object));
  }
  return result;
}

/// One vector for each robot of a chain.
template <class Scalar>
using PerRobot = std::vector<Vector<Scalar>>;

/// A function argument from which `Scalar` is not deduced.
template <class Scalar>
using PerRobotArg = const std::type_identity_t<PerRobot<Scalar>>&;

/// The grasps of one robot, in the order of objects and grasps, as operational points at the
/// objects' origins in world axes. At these points C stacks identities (Chang eq. 7.3).
template <class Scalar>
Points<Scalar> object_points(const ClosedChain<Scalar>& chain, int robot) {
  Points<Scalar> points;
  for (const auto& object : chain.objects) {
    for (const auto& grasp : object.grasps) {
      if (grasp.robot != robot) continue;
      OperationalPoint<Scalar> point = grasp.point;
      point.p = grasp.point.p + grasp.point.R * grasp.p;
      point.R = grasp.point.R * grasp.R;
      point.axes = PointAxes::world;
      point.rows = {true, true, true, true, true, true};
      points.push_back(point);
    }
  }
  return points;
}

/// C of one robot, with six rows for each of its grasps and six columns for each object of the
/// chain.
template <class Scalar>
Matrix<Scalar> connectivity(const ClosedChain<Scalar>& chain, int robot) {
  std::vector<int> held;
  for (int k = 0; k < static_cast<int>(chain.objects.size()); ++k) {
    for (const auto& grasp : chain.objects[static_cast<std::size_t>(k)].grasps) {
      if (grasp.robot == robot) held.push_back(k);
    }
  }
  const int rows = 6 * static_cast<int>(held.size());
  Matrix<Scalar> C = Matrix<Scalar>::Zero(rows, 6 * static_cast<int>(chain.objects.size()));
  for (int i = 0; i < static_cast<int>(held.size()); ++i) {
    C.template block<6, 6>(6 * i, 6 * held[static_cast<std::size_t>(i)]).setIdentity();
  }
  return C;
}

/// Pose and velocity of an object according to one grasp, world axes.
template <class Scalar>
struct HeldPose {
  Matrix3<Scalar> R;        ///< from object's axes to world axes
  Vector3<Scalar> p;        ///< origin of the object
  Vector6<Scalar> v;        ///< velocity of the object's origin over angular velocity
  Vector3<Scalar> to_hand;  ///< from the object's origin to the grasp's point
};

/// Poses and velocities of each object according to each of its grasps.
template <class Scalar>
std::vector<std::vector<HeldPose<Scalar>>> held_poses(const ClosedChain<Scalar>& chain,
                                                      PerRobotArg<Scalar> q,
                                                      PerRobotArg<Scalar> qd) {
  std::vector<Kinematics<Scalar>> robots;
  for (std::size_t r = 0; r < chain.robots.size(); ++r) {
    robots.push_back(kinematics<Scalar>(chain.robots[r], q[r], qd[r]));
  }
  std::vector<std::vector<HeldPose<Scalar>>> poses;
  for (const auto& object : chain.objects) {
    poses.emplace_back();
    for (const auto& grasp : object.grasps) {
      const auto& k = robots[static_cast<std::size_t>(grasp.robot)];
      const int body = grasp.point.body;
      const Vector3<Scalar> arm = grasp.point.p + grasp.point.R * grasp.p;
      const Vector3<Scalar> w = angular(k.v[body]);
      const Vector3<Scalar> velocity = linear(k.v[body]) + cross(w, arm);
      const Matrix3<Scalar>& R = k.R_world[body];
      poses.back().push_back({R * grasp.point.R * grasp.R, k.p_world[body] + R * arm,
                              stack<Scalar>(R * velocity, R * w),
                              -(R * (grasp.point.R * grasp.p))});
    }
  }
  return poses;
}

/// Lambda_obj at the object's origin, world axes.
template <class Scalar>
Matrix6<Scalar> object_inertia(const GraspedObject<Scalar>& object, const Matrix3<Scalar>& R) {
  const Matrix3<Scalar> c = cross_matrix(object.com);
  const Matrix3<Scalar> J = object.inertia - object.mass * (c * c);
  return spatial_inertia<Scalar>(object.mass, R * object.com, R * J * R.transpose());
}

/// mu_obj and p_obj at the object's origin, world axes: forces for its motion at constant velocity,
/// and its weight. Lambda_obj xdd + mu_obj + p_obj is the force that all hands together exert.
template <class Scalar>
struct ObjectBias {
  Vector6<Scalar> mu, p;
};

template <class Scalar>
ObjectBias<Scalar> object_bias(const GraspedObject<Scalar>& object, const HeldPose<Scalar>& held,
                               const Vector3<Scalar>& gravity) {
  const Matrix6<Scalar> I = object_inertia(object, held.R);
  const Vector3<Scalar> w = angular(held.v);
  const Vector3<Scalar> first_moment = held.R * (object.mass * object.com);
  const Matrix3<Scalar> J = I.template bottomRightCorner<3, 3>();
  return {stack<Scalar>(cross<Scalar>(w, cross(w, first_moment)), cross<Scalar>(w, J * w)),
          I * stack<Scalar>(-gravity, Vector3<Scalar>::Zero())};
}

/// Drift of the grasps of an object: pose and velocity according to grasp i minus those according
/// to its first grasp, linear over angular, world axes. The rotation is the sine of its angle along
/// its axis.
template <class Scalar>
struct GraspDrift {
  Vector6<Scalar> pose, velocity;
};

template <class Scalar>
GraspDrift<Scalar> grasp_drift(const HeldPose<Scalar>& first, const HeldPose<Scalar>& held) {
  Vector3<Scalar> turn = Vector3<Scalar>::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    turn += cross<Scalar>(first.R.col(axis), held.R.col(axis)) / Scalar(2);
  }
  return {stack<Scalar>(held.p - first.p, turn), held.v - first.v};
}

}  // namespace treeline::interpreter
