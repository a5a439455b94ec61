#pragma once

#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "drive/obstacle.hpp"

namespace treeline::drive {

/// Meaning of an entry of q. A floating joint has x y z qx qy qz qw in this order, a planar one
/// planar_x planar_y planar_theta.
enum class Measure { angle, length, x, y, z, qx, qy, qz, qw, planar_x, planar_y, planar_theta };

/// One entry of q. Limits are infinite where there are none.
struct DrivenCoordinate {
  std::string name;   ///< in commands: the joint's, or `joint.x` where the joint has several
  std::string joint;  ///< of the URDF; `base` for a floating base
  Measure measure = Measure::angle;
  int velocity_index = -1;  ///< of its velocity and force; -1 for a floating joint
  bool passive = false;     ///< without a motor: loops lead it
  double lower = -std::numeric_limits<double>::infinity();  ///< rad or m
  double upper = std::numeric_limits<double>::infinity();
  double velocity = std::numeric_limits<double>::infinity();  ///< rad/s or m/s
  double effort = std::numeric_limits<double>::infinity();    ///< N m or N
};

/// A point that the task moves.
struct DrivenPoint {
  std::string name;
  std::string link;
  std::array<double, 3> position{};            ///< of its frame in the link's, m
  std::array<double, 4> rotation{0, 0, 0, 1};  ///< of its frame in the link's, quaternion x y z w
  std::vector<std::string> rows;               ///< out of x y z rx ry rz
  bool local_axes = false;
};

/// An obstacle and what front ends draw.
struct DrivenObstacle {
  std::string name;
  std::array<double, 4> rotation{0, 0, 0, 1};  ///< of the box in the world, quaternion x y z w
  Obstacle shape;
};

/// Properties of a robot for front ends and the command language.
struct RobotDescription {
  std::string name;
  std::string checksum;    ///< of the files that it was made of, 16 hexadecimal digits
  bool floating = false;   ///< the base floats, held by ideal forces, and can be moved
  bool held = false;       ///< the base floats, and constraints hold the robot to the world
  bool on_ground = false;  ///< simulated on the ground z < 0, which holds nothing and only pushes
  bool has_controller = false;  ///< of its own: it gets goals, and moves as it will
  int velocities = 0;
  std::vector<DrivenCoordinate> coordinates;  ///< in the order of q
  std::vector<DrivenPoint> points;
  std::vector<std::string> links;  ///< that can be pulled, in the library's order
  std::vector<std::pair<std::string, double>> locked;
  double mass = 1.0;  ///< kg, of all links
  std::vector<DrivenObstacle> obstacles;
  std::vector<GuardedPoint> guarded;  ///< that keep away from them; the operational points first
  Repulsion repulsion;
  bool has_reference = false;  ///< a recorded motion that it can follow
  std::string urdf;            ///< text of the file
};

/// Whether the coordinate can be the goal of a joint command: it is no part of a floating joint,
/// and has a motor.
inline bool is_single(const DrivenCoordinate& coordinate) {
  return coordinate.velocity_index >= 0 && !coordinate.passive;
}

/// Whether it is measured in rad; else in m.
inline bool is_angle(const DrivenCoordinate& coordinate) {
  return coordinate.measure == Measure::angle || coordinate.measure == Measure::planar_theta;
}

}  // namespace treeline::drive
