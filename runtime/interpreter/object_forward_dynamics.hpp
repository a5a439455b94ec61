#pragma once

#include "interpreter/augmented_object.hpp"
#include "interpreter/forward_dynamics.hpp"
#include "interpreter/object_control_torque.hpp"

namespace treeline::interpreter {

/// Gains of Baumgarte's stabilisation: each grasp accelerates relative to the first grasp of its
/// object by -damping * relative velocity - stiffness * drift. Zero gains: Chang table 7.2.
template <class Scalar>
struct Stabilisation {
  Scalar damping = Scalar(0);    ///< 1/s
  Scalar stiffness = Scalar(0);  ///< 1/s^2
};

template <class Scalar>
struct ClosedChainMotion {
  PerRobot<Scalar> qdd;
  Vector<Scalar> xdd_object;  ///< six per object: acceleration of its origin over angular
                              ///< acceleration, world axes
  Vector<Scalar> f_grasp;     ///< six per grasp, object after object: force and moment of the hand
                              ///< ON the object at the grasp's point, world axes
  Vector<Scalar> internal;    ///< internal forces as in `object_control_torque`
};

namespace detail {

/// Acceleration that stabilisation commands for each grasp, object after object.
template <class Scalar>
std::vector<std::vector<Vector6<Scalar>>> corrections(
    const std::vector<std::vector<HeldPose<Scalar>>>& poses, const Stabilisation<Scalar>& gains) {
  std::vector<std::vector<Vector6<Scalar>>> result;
  for (const auto& object : poses) {
    result.emplace_back();
    for (const auto& held : object) {
      const auto drift = grasp_drift(object.front(), held);
      result.back().push_back(-gains.damping * drift.velocity - gains.stiffness * drift.pose);
    }
  }
  return result;
}

/// Moves the forces of one robot's grasps from the objects' origins to the grasps' points, and
/// computes the internal forces by the virtual linkage.
template <class Scalar>
void report_grasp_forces(const ClosedChain<Scalar>& chain,
                         const std::vector<std::vector<HeldPose<Scalar>>>& poses,
                         const std::vector<Vector<Scalar>>& of_robots,
                         ClosedChainMotion<Scalar>& motion) {
  std::vector<int> next(chain.robots.size(), 0);
  motion.internal.resize(internal_force_count(chain));
  int internal_at = 0;
  for (std::size_t k = 0; k < chain.objects.size(); ++k) {
    const auto& object = chain.objects[k];
    Vector<Scalar> in_object(6 * static_cast<int>(object.grasps.size()));
    for (std::size_t i = 0; i < object.grasps.size(); ++i) {
      const auto r = static_cast<std::size_t>(object.grasps[i].robot);
      Vector6<Scalar> f = of_robots[r].template segment<6>(next[r]);
      next[r] += 6;
      f.template tail<3>() -= cross<Scalar>(poses[k][i].to_hand, linear(f));
      motion.f_grasp.conservativeResize(motion.f_grasp.size() + 6);
      motion.f_grasp.template tail<6>() = f;
      const Matrix3<Scalar> R = poses[k][i].R.transpose();
      in_object.template segment<6>(6 * static_cast<int>(i)) =
          stack<Scalar>(R * linear(f), R * angular(f));
    }
    const Matrix<Scalar> W = grasp_description(object);
    const int count = internal_force_count(static_cast<int>(object.grasps.size()));
    motion.internal.segment(internal_at, count) = W.bottomRows(count) * in_object;
    internal_at += count;
  }
}

}  // namespace detail

/// Motion of closed chains under joint forces (Chang table 7.2): open-chain qdd_o and xdd_o = J
/// qdd_o + Jd qd, then xdd = (Lambda_obj + C^T Lambda_e C)^-1 (C^T Lambda_e xdd_o - mu_obj -
/// p_obj), f_t = Lambda_e (xdd_o - C xdd), qdd = qdd_o - A^-1 J^T f_t. What stabilisation commands
/// is subtracted from xdd_o.
template <class Scalar>
ClosedChainMotion<Scalar> object_forward_dynamics(
    const ClosedChain<Scalar>& chain, PerRobotArg<Scalar> q, PerRobotArg<Scalar> qd,
    PerRobotArg<Scalar> tau, const Stabilisation<std::type_identity_t<Scalar>>& gains) {
  const auto poses = held_poses<Scalar>(chain, q, qd);
  const auto corrections = detail::corrections(poses, gains);
  const int size = 6 * static_cast<int>(chain.objects.size());
  Matrix<Scalar> Lambda_sum = Matrix<Scalar>::Zero(size, size);
  Vector<Scalar> F = Vector<Scalar>::Zero(size);
  for (std::size_t k = 0; k < chain.objects.size(); ++k) {
    const int at = 6 * static_cast<int>(k);
    const auto bias = object_bias(chain.objects[k], poses[k].front(), chain.robots.front().gravity);
    Lambda_sum.template block<6, 6>(at, at) = object_inertia(chain.objects[k], poses[k].front().R);
    F.template segment<6>(at) = -bias.mu - bias.p;
  }
  ClosedChainMotion<Scalar> motion;
  std::vector<Vector<Scalar>> xdd_o, of_robots;
  std::vector<Matrix<Scalar>> Lambda, C;
  for (std::size_t r = 0; r < chain.robots.size(); ++r) {
    const int robot = static_cast<int>(r);
    const auto points = object_points(chain, robot);
    motion.qdd.push_back(forward_dynamics<Scalar>(chain.robots[r], q[r], qd[r], tau[r]));
    C.push_back(connectivity(chain, robot));
    Lambda.push_back(points.empty() ? Matrix<Scalar>(0, 0)
                                    : lambda<Scalar>(chain.robots[r], points, q[r]));
    xdd_o.push_back(
        point_accelerations<Scalar>(chain.robots[r], points, q[r], qd[r], motion.qdd[r]) -
        detail::of_robot(chain, robot, corrections));
    Lambda_sum += C[r].transpose() * Lambda[r] * C[r];
    F += C[r].transpose() * (Lambda[r] * xdd_o[r]);
  }
  motion.xdd_object = Lambda_sum.ldlt().solve(F);
  for (std::size_t r = 0; r < chain.robots.size(); ++r) {
    const auto points = object_points(chain, static_cast<int>(r));
    const Model<Scalar> weightless = without_gravity<Scalar>(chain.robots[r]);
    const Vector<Scalar> rest = Vector<Scalar>::Zero(weightless.nv);
    of_robots.push_back(Lambda[r] * (xdd_o[r] - C[r] * motion.xdd_object));
    motion.qdd[r] -= forward_dynamics<Scalar>(weightless, q[r], rest, rest, points, of_robots[r]);
  }
  detail::report_grasp_forces(chain, poses, of_robots, motion);
  return motion;
}

/// Motion of closed chains under joint forces, by one system for the grasps' forces f: (Lambda_e^-1
/// + C Lambda_obj^-1 C^T) f = xdd_o - C xdd_free, where xdd_free are the objects' accelerations if
/// nobody holds them. It does not need Lambda_e, which is not finite if a hand cannot move. If
/// forces are not unique, `law` relaxes those of later grasps. For chains of one robot.
template <class Scalar>
ClosedChainMotion<Scalar> object_forward_dynamics(
    const ClosedChain<Scalar>& chain, PerRobotArg<Scalar> q, PerRobotArg<Scalar> qd,
    PerRobotArg<Scalar> tau, const Stabilisation<std::type_identity_t<Scalar>>& gains,
    const TaskLaw<Scalar>& law) {
  const Model<Scalar>& robot = chain.robots.front();
  const auto poses = held_poses<Scalar>(chain, q, qd);
  const int size = 6 * static_cast<int>(chain.objects.size());
  Matrix<Scalar> mobility = Matrix<Scalar>::Zero(size, size);
  Vector<Scalar> free(size);
  for (std::size_t k = 0; k < chain.objects.size(); ++k) {
    const int at = 6 * static_cast<int>(k);
    const auto bias = object_bias(chain.objects[k], poses[k].front(), robot.gravity);
    mobility.template block<6, 6>(at, at) =
        inverse_of_positive_definite<Scalar>(object_inertia(chain.objects[k], poses[k].front().R));
    free.template segment<6>(at) =
        -(mobility.template block<6, 6>(at, at) * Vector<Scalar>(bias.mu + bias.p));
  }
  const auto points = object_points(chain, 0);
  const Matrix<Scalar> C = connectivity(chain, 0);
  ClosedChainMotion<Scalar> motion;
  motion.qdd.push_back(forward_dynamics<Scalar>(robot, q[0], qd[0], tau[0]));
  const Vector<Scalar> xdd_o =
      point_accelerations<Scalar>(robot, points, q[0], qd[0], motion.qdd[0]) -
      detail::of_robot(chain, 0, detail::corrections(poses, gains));
  const Matrix<Scalar> A =
      lambda_inverse<Scalar>(robot, points, q[0]) + C * mobility * C.transpose();
  const Vector<Scalar> f = bordered_inverse<Scalar>(A, law) * (xdd_o - C * free);
  motion.xdd_object = free + mobility * (C.transpose() * f);
  const Model<Scalar> weightless = without_gravity<Scalar>(robot);
  const Vector<Scalar> rest = Vector<Scalar>::Zero(robot.nv);
  motion.qdd[0] -= forward_dynamics<Scalar>(weightless, q[0], rest, rest, points, f);
  detail::report_grasp_forces(chain, poses, {f}, motion);
  return motion;
}

}  // namespace treeline::interpreter
