#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline {

inline std::string robot_file(const std::string& name, const std::string& file) {
  return std::string(TREELINE_ROBOTS_DIR) + "/" + name + "/" + file;
}

/// Fails the test for each warning and error.
inline void expect_silence(const Diagnostics& diagnostics) {
  for (const Diagnostic& d : diagnostics.list()) {
    if (d.severity != Severity::note) ADD_FAILURE() << to_string(d);
  }
}

/// Loads robots/NAME/NAME.urdf. The test cannot continue without it.
inline Robot load_robot(const std::string& name) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(robot_file(name, name + ".urdf"), diagnostics);
  expect_silence(diagnostics);
  if (!robot) throw std::runtime_error(name + " cannot be read");
  return *robot;
}

inline Scene load_scene(const std::string& name, const std::string& file, const Robot& robot) {
  Diagnostics diagnostics;
  const auto scene = read_scene(robot_file(name, file), robot, diagnostics);
  expect_silence(diagnostics);
  if (!scene) throw std::runtime_error(name + "/" + file + " cannot be read");
  return *scene;
}

inline const Link& find_link(const Robot& robot, const std::string& name) {
  for (const Link& link : robot.links) {
    if (link.name == name) return link;
  }
  throw std::runtime_error("no link " + name);
}

/// The joint that carries the link with this name.
inline const Joint& find_joint_of(const Robot& robot, const std::string& link) {
  for (const Joint& joint : robot.joints) {
    if (robot.links[static_cast<std::size_t>(joint.child)].name == link) return joint;
  }
  throw std::runtime_error("no joint carries " + link);
}

}  // namespace treeline
