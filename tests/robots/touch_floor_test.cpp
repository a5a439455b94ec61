// Would catch: a start, a target or gains in robots/humanoid24/touch_floor.yaml that do not fit the
// robot, so that the task begins or ends outside the limits or near a singularity.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <vector>

#include "interpreter/instances.hpp"
#include "load_robot.hpp"

namespace treeline {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

YAML::Node task() {
  return YAML::LoadFile(robot_file("humanoid24", "touch_floor.yaml"));
}

/// One value for each joint of the robot, in the order of its coordinates.
VectorXd per_joint(const Robot& robot, const YAML::Node& values) {
  const auto model = model_from_robot<double>(robot, Scene{});
  VectorXd result(model.nv);
  for (const auto& body : model.bodies) {
    if (body.kind == interpreter::JointKind::fixed) continue;
    result[body.v] = values[find_joint_of(robot, body.name).name].as<double>();
  }
  return result;
}

TEST(TouchFloor, NamesEveryJointOnceAndNoOther) {
  const Robot robot = load_robot("humanoid24");
  for (const char* key : {"start", "posture_stiffness"}) {
    EXPECT_EQ(task()[key].size(), robot.joints.size()) << key;
    for (const Joint& joint : robot.joints) {
      EXPECT_TRUE(task()[key][joint.name].IsDefined()) << key << ": " << joint.name;
    }
  }
}

TEST(TouchFloor, StartsWithinTheLimits) {
  const Robot robot = load_robot("humanoid24");
  for (const Joint& joint : robot.joints) {
    const double q = task()["start"][joint.name].as<double>();
    EXPECT_GE(q, joint.limits->lower + 0.1) << joint.name;
    EXPECT_LE(q, joint.limits->upper - 0.1) << joint.name;
  }
}

TEST(TouchFloor, StartsWhereTheReadmeSays) {
  const Robot robot = load_robot("humanoid24");
  const Scene scene = load_scene("humanoid24", "scene.yaml", robot);
  const auto model = model_from_robot<double>(robot, scene);
  const auto hands = points_from_scene(model, scene.operational_points);
  const VectorXd q = per_joint(robot, task()["start"]);
  const auto poses = interpreter::forward_kinematics(model, hands, q);
  // The five decimals in the README.
  EXPECT_LT((poses[0].position - Vector3d(0.48724, 0.20514, 0.83252)).norm(), 1e-5);
  EXPECT_LT((poses[1].position - Vector3d(0.01780, -0.63341, 0.86678)).norm(), 1e-5);
  const auto J = interpreter::jacobian(model, hands, q);
  ASSERT_EQ(J.rows(), 12);
  EXPECT_GT(Eigen::JacobiSVD<Eigen::MatrixXd>(J).singularValues()[11], 0.15);
}

/// The task with the dynamically consistent acceleration that table 6.1 commands, and springs that
/// are taken at the end of a step. The posture's path depends only on its own gains, so the hands'
/// stiffness may be one that permits large steps.
struct TouchFloorMotion {
  static constexpr double kStiffness = 400, kDamping = 40, kStep = 0.005;

  Robot robot = load_robot("humanoid24");
  Scene scene = load_scene("humanoid24", "scene.yaml", robot);
  interpreter::Model<double> model = model_from_robot<double>(robot, scene);
  interpreter::Points<double> hands = points_from_scene(model, scene.operational_points);
  VectorXd start = per_joint(robot, task()["start"]);
  double spring = task()["springs"]["stiffness"].as<double>();
  double margin = task()["springs"]["margin"].as<double>();
  double strength = task()["springs"]["strength"].as<double>();
  double duration = task()["left_hand"]["duration"].as<double>();
  double settle = task()["left_hand"]["settle"].as<double>();
  std::vector<interpreter::PointPose<double>> at_start =
      interpreter::forward_kinematics(model, hands, start);
  Vector3d way = target() - at_start[0].position;

  static Vector3d target() {
    const auto xyz = task()["left_hand"]["target"].as<std::vector<double>>();
    return {xyz[0], xyz[1], xyz[2]};
  }

  /// Errors of both hands from their desired poses at `t`: metres and radians.
  [[nodiscard]] VectorXd error(double t, const VectorXd& q) const {
    const double u = std::min(t / duration, 1.0);
    const auto is = interpreter::forward_kinematics(model, hands, q);
    VectorXd e = VectorXd::Zero(12);
    e.head<3>() = (3 - 2 * u) * u * u * way;
    for (int hand : {0, 1}) {
      const auto h = static_cast<std::size_t>(hand);
      e.segment<3>(6 * hand) += at_start[h].position - is[h].position;
      for (int axis = 0; axis < 3; ++axis) {
        const Vector3d a = is[h].rotation.col(axis), b = at_start[h].rotation.col(axis);
        e.segment<3>(6 * hand + 3) += 0.5 * a.cross(b);
      }
    }
    return e;
  }

  [[nodiscard]] VectorXd command(double t, const VectorXd& q, const VectorXd& velocity) const {
    VectorXd xdd = kStiffness * error(t, q) - kDamping * velocity;
    const double u = t / duration;
    if (u >= 1) return xdd;
    xdd.head<3>() += kDamping * 6 * u * (1 - u) / duration * way;
    xdd.head<3>() += (6 - 12 * u) / (duration * duration) * way;
    return xdd;
  }

  /// Torque that pushes joints away from limits that are near.
  [[nodiscard]] VectorXd push(const VectorXd& q) const {
    VectorXd torque = VectorXd::Zero(q.size());
    const auto share = [&](double distance) {
      const double x = std::clamp(1 - distance / margin, 0.0, 1.0);
      return x * x * (3 - 2 * x);
    };
    for (const auto& body : model.bodies) {
      if (body.kind == interpreter::JointKind::fixed) continue;
      const auto& limits = *find_joint_of(robot, body.name).limits;
      torque[body.v] =
          strength * (share(q[body.v] - limits.lower) - share(limits.upper - q[body.v]));
    }
    return torque;
  }

  [[nodiscard]] VectorXd posture(const VectorXd& q, const VectorXd& qd,
                                 const Eigen::MatrixXd& M) const {
    const VectorXd damper = 2 * (spring * M.diagonal()).cwiseSqrt();
    Eigen::MatrixXd implicit = M;
    implicit.diagonal() += kStep * damper;
    implicit.diagonal().array() += kStep * kStep * spring;
    return implicit.llt().solve(spring * (start - q - kStep * qd) - damper.cwiseProduct(qd) +
                                push(q));
  }

  [[nodiscard]] VectorXd acceleration(double t, const VectorXd& q, const VectorXd& qd) const {
    const Eigen::MatrixXd J = interpreter::jacobian(model, hands, q);
    const Eigen::MatrixXd M = interpreter::mass_matrix(model, q);
    const VectorXd qdd_0 = posture(q, qd, M);
    const Eigen::MatrixXd M_inv_Jt = M.llt().solve(J.transpose());
    const VectorXd lack =
        command(t, q, J * qd) - J * qdd_0 - interpreter::bias_acceleration(model, hands, q, qd);
    return qdd_0 + M_inv_Jt * (J * M_inv_Jt).ldlt().solve(lack);
  }

  void expect_good_state(double t, const VectorXd& q, const VectorXd& qd) const {
    const Eigen::MatrixXd J = interpreter::jacobian(model, hands, q);
    EXPECT_GT(Eigen::JacobiSVD<Eigen::MatrixXd>(J).singularValues()[11], 0.1) << t << " s";
    for (const auto& body : model.bodies) {
      if (body.kind == interpreter::JointKind::fixed) continue;
      const Joint& joint = find_joint_of(robot, body.name);
      EXPECT_GT(q[body.v], joint.limits->lower + 0.1) << joint.name << " at " << t << " s";
      EXPECT_LT(q[body.v], joint.limits->upper - 0.1) << joint.name << " at " << t << " s";
      EXPECT_LT(std::abs(qd[body.v]), joint.limits->velocity) << joint.name << " at " << t << " s";
    }
  }
};

TEST(TouchFloor, StaysWithinTheLimitsAndAwayFromSingularities) {
  const TouchFloorMotion motion;
  constexpr double kStep = TouchFloorMotion::kStep;
  VectorXd q = motion.start, qd = VectorXd::Zero(24);
  const int ticks = static_cast<int>((motion.duration + motion.settle) / kStep);
  for (int tick = 0; tick < ticks; ++tick) {
    const double t = tick * kStep;
    const VectorXd qdd = motion.acceleration(t, q, qd);
    q += kStep * qd + kStep * kStep / 2 * qdd;
    qd += kStep * qdd;
    ASSERT_LT(motion.error(t + kStep, q).norm(), 0.01) << "at " << t << " s";
    if (tick % 20 == 0) motion.expect_good_state(t, q, qd);
  }
  EXPECT_LT(motion.error(ticks * kStep, q).norm(), 1e-4);
}

}  // namespace
}  // namespace treeline
