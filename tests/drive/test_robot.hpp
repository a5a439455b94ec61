#pragma once
// A description with every kind of coordinate, for tests of the language and the wire.

#include "drive/robot_description.hpp"

namespace treeline::test {

/// Floating base, an elbow within 1 rad, a slider within 0.5 m, a wheel without limits, a planar
/// joint; the points `tool` and `camera`.
inline drive::RobotDescription every_kind_of_joint() {
  using drive::DrivenCoordinate;
  using drive::Measure;
  drive::RobotDescription robot;
  robot.name = "every";
  robot.checksum = "0123456789abcdef";
  robot.floating = true;
  robot.velocities = 12;
  int next = 6;
  const char* const floating[] = {"x", "y", "z", "qx", "qy", "qz", "qw"};
  for (int i = 0; i < 7; ++i) {
    DrivenCoordinate coordinate;
    coordinate.name = std::string("base.") + floating[i];
    coordinate.joint = "base";
    coordinate.measure = static_cast<Measure>(static_cast<int>(Measure::x) + i);
    robot.coordinates.push_back(coordinate);
  }
  const auto add = [&](const char* name, const char* joint, Measure measure, double reach) {
    DrivenCoordinate coordinate;
    coordinate.name = name;
    coordinate.joint = joint;
    coordinate.measure = measure;
    coordinate.velocity_index = next++;
    if (reach > 0) {
      coordinate.lower = -reach;
      coordinate.upper = reach;
    }
    robot.coordinates.push_back(coordinate);
  };
  add("elbow", "elbow", Measure::angle, 1.0);
  add("slider", "slider", Measure::length, 0.5);
  add("wheel", "wheel", Measure::angle, 0.0);
  add("table.x", "table", Measure::planar_x, 0.0);
  add("table.y", "table", Measure::planar_y, 0.0);
  add("table.theta", "table", Measure::planar_theta, 0.0);
  robot.points = {{"tool", "hand", {}, {0, 0, 0, 1}, {"x", "y", "z"}, false},
                  {"camera", "head", {}, {0, 0, 0, 1}, {"rx"}, true}};
  robot.links = {"hand", "head"};
  return robot;
}

}  // namespace treeline::test
