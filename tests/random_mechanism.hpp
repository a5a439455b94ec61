#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

/// Random robots for tests of invariants: physically valid, otherwise as unusual as a URDF may be.
/// Equal seeds and options always give the same robot.
namespace treeline::tests {

/// Frequency of each joint type, relative to the others.
struct JointMix {
  double revolute = 5, continuous = 1, prismatic = 2, fixed = 1, floating = 0.3, planar = 0.5,
         ball = 0;
};

struct RandomOptions {
  int joints = 8;          ///< in the URDF, of all types
  double branching = 0.3;  ///< 0: a serial chain; 1: each link is attached to any earlier one
  JointMix mix{};
  bool floating_base = false;
  double mimic = 0;      ///< chance that a joint of one degree follows an earlier one
  double locked = 0;     ///< chance that the scene locks a joint of one degree
  double aligned = 0.5;  ///< chance of axis-aligned axes, quarter turns, zero offsets
  double massless = 0;   ///< chance that a link behind a fixed joint has no inertia
  double rotors = 0;     ///< chance that a joint of one degree has a motor's rotor
  double drives = 0;     ///< chance that it has friction, and that it has a spring
  int operational_points = 1;
  bool all_rows = true;  ///< false: a random subset of at least one row
  int external_forces = 0;
  /// Some followers turn the other way, some are as fast as their leaders, some follow followers.
  bool varied_mimics = false;
};

struct RandomMechanism {
  Robot robot;
  Scene scene;
};

/// Random numbers, computed with its own arithmetic, so that they are the same with every standard
/// library.
class Rng {
 public:
  explicit Rng(std::uint64_t seed) : engine_(seed) {}

  /// A number in [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * unit(); }
  bool chance(double probability) { return unit() < probability; }
  /// An index in 0..count-1.
  int below(int count) { return static_cast<int>(unit() * count); }
  /// A decimal number with three digits, as people write in files.
  double rounded(double low, double high) { return std::round(uniform(low, high) * 1000) / 1000; }

 private:
  std::mt19937_64 engine_;
};

namespace detail {

inline std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

inline std::array<double, 3> random_vector(Rng& rng, double size) {
  return {rng.rounded(-size, size), rng.rounded(-size, size), rng.rounded(-size, size)};
}

inline Pose random_pose(Rng& rng, double size, double aligned) {
  Pose pose{random_vector(rng, size), random_vector(rng, 3)};
  for (double& x : pose.xyz) {
    if (rng.chance(aligned)) x = 0;
  }
  if (rng.chance(aligned)) {
    constexpr std::array kQuarters{0.0, 0.0, 1.5707963267948966, -1.5707963267948966,
                                   3.141592653589793};
    for (double& angle : pose.rpy) angle = kQuarters[at(rng.below(5))];
  }
  return pose;
}

inline std::array<double, 3> random_axis(Rng& rng, double aligned) {
  std::array<double, 3> axis{};
  if (rng.chance(aligned)) {
    axis[at(rng.below(3))] = rng.chance(0.3) ? -1 : 1;
    return axis;
  }
  double norm = 0;
  while (norm < 0.1) {
    axis = random_vector(rng, 1);
    norm = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  }
  for (double& x : axis) x /= norm;
  return axis;
}

/// The inertia of six point masses, which satisfies the triangle inequality with a large margin.
inline Inertial random_inertial(Rng& rng, double aligned) {
  Inertial inertial;
  inertial.mass = rng.rounded(0.2, 8);
  inertial.origin = random_pose(rng, 0.2, aligned);
  const auto square = [&] { return inertial.mass * std::pow(rng.uniform(0.03, 0.15), 2); };
  const double xx = square(), yy = square(), zz = square();
  Eigen::Matrix3d second_moment = Eigen::Vector3d(xx, yy, zz).asDiagonal();
  if (!rng.chance(aligned)) {
    const Eigen::Vector4d coefficients(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1),
                                       rng.uniform(1, 2));
    const Eigen::Matrix3d R = Eigen::Quaterniond(coefficients.normalized()).toRotationMatrix();
    second_moment = (R * second_moment * R.transpose()).eval();
  }
  const Eigen::Matrix3d J = second_moment.trace() * Eigen::Matrix3d::Identity() - second_moment;
  inertial.ixx = J(0, 0);
  inertial.iyy = J(1, 1);
  inertial.izz = J(2, 2);
  inertial.ixy = J(0, 1);
  inertial.ixz = J(0, 2);
  inertial.iyz = J(1, 2);
  return inertial;
}

inline JointType random_type(Rng& rng, const JointMix& mix) {
  const std::array<std::pair<double, JointType>, 7> kWeights{
      {{mix.revolute, JointType::revolute},
       {mix.continuous, JointType::continuous},
       {mix.prismatic, JointType::prismatic},
       {mix.fixed, JointType::fixed},
       {mix.floating, JointType::floating},
       {mix.planar, JointType::planar},
       {mix.ball, JointType::ball}}};
  double total = 0;
  for (const auto& [weight, type] : kWeights) total += weight;
  double drawn = rng.uniform(0, total);
  for (const auto& [weight, type] : kWeights) {
    if (drawn < weight) return type;
    drawn -= weight;
  }
  return JointType::revolute;
}

inline bool has_one_degree(const Joint& joint) {
  return info_of(joint.type).has_one_freedom();
}

inline Limits random_limits(Rng& rng, JointType type) {
  const double range = type == JointType::prismatic ? 0.5 : 2.8;
  return {-rng.rounded(0.1, range), rng.rounded(0.1, range), 100, 5};
}

/// Links are attached to earlier links, but the file lists them in random order.
inline Robot random_tree(Rng& rng, const RandomOptions& options) {
  Robot robot;
  robot.name = "random_robot";
  robot.links.push_back({"base", random_inertial(rng, options.aligned), 0});
  robot.root = 0;
  for (int i = 0; i < options.joints; ++i) {
    Joint joint;
    joint.name = "joint_" + std::to_string(i);
    joint.type = random_type(rng, options.mix);
    joint.parent = rng.chance(options.branching) ? rng.below(i + 1) : i;
    joint.child = i + 1;
    joint.origin = random_pose(rng, 0.5, options.aligned);
    joint.axis = random_axis(rng, options.aligned);
    if (has_one_degree(joint) && joint.type != JointType::continuous) {
      joint.limits = random_limits(rng, joint.type);
    }
    robot.joints.push_back(joint);
    robot.links.push_back({"link_" + std::to_string(i), random_inertial(rng, options.aligned), 0});
  }
  for (int i = static_cast<int>(robot.joints.size()) - 1; i > 0; --i) {
    std::swap(robot.joints[at(i)], robot.joints[at(rng.below(i + 1))]);
  }
  return robot;
}

/// Only links behind fixed joints lose their inertia, because a moving joint needs something to
/// move.
inline void remove_inertias(Rng& rng, const RandomOptions& options, Robot& robot) {
  for (const Joint& joint : robot.joints) {
    if (joint.type == JointType::fixed && rng.chance(options.massless)) {
      robot.links[at(joint.child)].inertial.reset();
    }
  }
}

/// Leaders are never mimics themselves. They may be anywhere in the tree.
inline void add_mimics(Rng& rng, const RandomOptions& options, Robot& robot) {
  const int count = static_cast<int>(robot.joints.size());
  for (int i = 0; i < count; ++i) {
    Joint& joint = robot.joints[at(i)];
    const int leader = rng.below(count);
    const Joint& other = robot.joints[at(leader)];
    if (!rng.chance(options.mimic) || leader == i || !has_one_degree(joint) ||
        !has_one_degree(other) || other.mimic) {
      continue;
    }
    const bool is_led = std::any_of(robot.joints.begin(), robot.joints.end(),
                                    [&](const Joint& j) { return j.mimic && j.mimic->joint == i; });
    if (!is_led) joint.mimic = Mimic{leader, rng.rounded(0.3, 2), rng.rounded(-0.5, 0.5)};
  }
}

/// See `RandomOptions::varied_mimics`.
inline void vary_mimics(Rng& rng, Robot& robot) {
  const int count = static_cast<int>(robot.joints.size());
  const auto follows = [&](int i) { return robot.joints[at(i)].mimic.has_value(); };
  for (int i = 0; i < count; ++i) {
    if (!follows(i)) continue;
    Mimic& mimic = *robot.joints[at(i)].mimic;
    if (rng.chance(0.3)) mimic.multiplier = 1;
    if (rng.chance(0.5)) mimic.multiplier = -mimic.multiplier;
    const int other = rng.below(count);
    const bool is_led = std::any_of(robot.joints.begin(), robot.joints.end(),
                                    [&](const Joint& j) { return j.mimic && j.mimic->joint == i; });
    if (other == i || is_led || !follows(other)) continue;
    if (follows(robot.joints[at(other)].mimic->joint)) continue;
    mimic.joint = other;
    mimic.multiplier = mimic.multiplier < 0 ? -0.5 : 2;  // so that the product is a double
  }
}

inline ScenePoint random_point(Rng& rng, const RandomOptions& options, const Robot& robot,
                               const std::string& name) {
  ScenePoint point;
  point.name = name;
  const int links = static_cast<int>(robot.links.size());
  point.link =
      robot.links[at(rng.chance(0.7) ? links - 1 - rng.below((links + 2) / 3) : rng.below(links))]
          .name;
  point.origin = random_pose(rng, 0.3, options.aligned);
  point.axes = rng.chance(0.5) ? Axes::world : Axes::local;
  return point;
}

inline void drop_rows(Rng& rng, ScenePoint& point) {
  for (bool& row : point.rows) row = rng.chance(0.5);
  point.rows[at(rng.below(6))] = true;
}

}  // namespace detail

namespace detail {

inline void add_friction_and_springs(Rng& rng, const RandomOptions& options, const Robot& robot,
                                     Scene& scene) {
  if (options.drives <= 0) return;
  for (const Joint& joint : robot.joints) {
    if (!has_one_degree(joint) || scene.locked.contains(joint.name)) continue;
    if (rng.chance(options.drives)) {
      const double friction = rng.chance(0.5) ? rng.rounded(0.1, 5) : 0;
      scene.joint_friction[joint.name] = {rng.rounded(0, 5), friction, rng.rounded(0.05, 0.5)};
    }
    if (rng.chance(options.drives)) {
      scene.joint_springs[joint.name] = {rng.rounded(1, 50), rng.rounded(-1, 1)};
    }
  }
}

}  // namespace detail

/// The centre of mass as a point, with one to three of its rows.
inline ScenePoint random_center(Rng& rng) {
  ScenePoint point;
  point.name = "center";
  point.center_of_mass = true;
  point.rows = {rng.chance(0.7), rng.chance(0.7), rng.chance(0.7), false, false, false};
  point.rows[detail::at(rng.below(3))] = true;
  return point;
}

/// Draws a robot and a scene from `seed`. The scene asks for all functions. With fewer degrees of
/// freedom than controlled rows, or with points on links that do not move, Lambda does not exist
/// but its inverse does.
inline RandomMechanism random_mechanism(std::uint64_t seed, const RandomOptions& options = {}) {
  Rng rng(seed);
  RandomMechanism made;
  made.robot = detail::random_tree(rng, options);
  detail::remove_inertias(rng, options, made.robot);
  detail::add_mimics(rng, options, made.robot);
  if (options.varied_mimics) detail::vary_mimics(rng, made.robot);
  Scene& scene = made.scene;
  scene.name = "random_robot";
  scene.noise = 0;  // sums of decimals that nearly vanish must count in 50 digits
  scene.singular = SingularTasks::exact;  // plain solves: tests of algebra compare many more digits
  scene.base = options.floating_base ? Base::floating : Base::fixed;
  if (rng.chance(0.3)) scene.gravity = detail::random_vector(rng, 10);
  for (int i = 0; i < options.operational_points; ++i) {
    scene.operational_points.push_back(
        detail::random_point(rng, options, made.robot, "point_" + std::to_string(i)));
    if (!options.all_rows) detail::drop_rows(rng, scene.operational_points.back());
  }
  for (int i = 0; i < options.external_forces; ++i) {
    scene.external_forces.push_back(
        detail::random_point(rng, options, made.robot, "force_" + std::to_string(i)));
  }
  scene.functions.assign(kDefaultFunctions.begin(), kDefaultFunctions.end());
  for (const Joint& joint : made.robot.joints) {
    if (detail::has_one_degree(joint) && !joint.mimic && rng.chance(options.locked)) {
      scene.locked[joint.name] = rng.rounded(-1, 1);
    }
  }
  for (const Joint& joint : made.robot.joints) {
    if (options.rotors > 0 && detail::has_one_degree(joint) && !scene.locked.contains(joint.name) &&
        rng.chance(options.rotors)) {
      scene.armature[joint.name] = rng.rounded(0.01, 2);
    }
  }
  detail::add_friction_and_springs(rng, options, made.robot, scene);
  return made;
}

}  // namespace treeline::tests
