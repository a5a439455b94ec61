#include "plan.hpp"

#include <fmt/core.h>
#include <urdf_parser/urdf_parser.h>
#include <yaml-cpp/yaml.h>

namespace treeline::experiments {
namespace {

void read_joints(const YAML::Node& node, std::vector<std::string>& names,
                 std::vector<double>& values) {
  for (const auto& entry : node) {
    names.push_back(entry.first.as<std::string>());
    values.push_back(entry.second.as<double>());
  }
}

double positive(const YAML::Node& node, const char* key) {
  const double value = node[key].as<double>();
  if (!(value > 0.0)) {
    throw YAML::Exception(node[key].Mark(), fmt::format("{} must be positive", key));
  }
  return value;
}

void fill_plan(const YAML::Node& root, const std::string& mover, Plan& plan) {
  read_joints(root["start"], plan.joints, plan.start);
  if (const YAML::Node springs = root["springs"]) {
    plan.spring = positive(springs, "stiffness");
    plan.limit_margin = positive(springs, "margin");
    plan.limit_strength = positive(springs, "strength");
  }
  if (mover.empty()) return;
  std::vector<std::string> names;
  read_joints(root["posture_stiffness"], names, plan.posture_stiffness);
  if (names != plan.joints) {
    throw YAML::Exception(root["posture_stiffness"].Mark(),
                          "start and posture_stiffness must list the same joints");
  }
  const YAML::Node moved = root[mover];
  plan.target = moved["target"].as<std::array<double, 3>>();
  plan.duration = positive(moved, "duration");
  plan.settle = positive(moved, "settle");
  plan.rate = positive(root["task"], "rate");
  plan.stiffness = positive(root["task"], "stiffness");
  plan.damping = positive(root["task"], "damping");
}

}  // namespace

bool read_plan(const std::string& path, Plan& plan, std::string& error, const std::string& mover) {
  try {
    fill_plan(YAML::LoadFile(path), mover, plan);
  } catch (const YAML::Exception& exception) {
    error = fmt::format("{}: {}", path, exception.what());
    return false;
  }
  return true;
}

bool count_joints(const std::string& path, const Plan& plan, int robot_joints, std::string& error) {
  if (plan.joints.size() == static_cast<std::size_t>(robot_joints)) return true;
  error =
      fmt::format("{} lists {} joints, the robot has {}", path, plan.joints.size(), robot_joints);
  return false;
}

std::string stopped(const servo::Fault& fault, const Plan& plan) {
  if (!fault) return "";
  const auto joint = static_cast<std::size_t>(fault.index);
  const bool named = fault.index >= 0 && joint < plan.joints.size();
  return "stopped: " + servo::describe(fault, named ? plan.joints[joint] : "");
}

bool read_limits(const std::string& path, const std::vector<std::string>& joints,
                 JointLimits& limits, std::string& error) {
  const auto robot = urdf::parseURDFFile(path);
  if (!robot) {
    error = fmt::format("{}: cannot be read as URDF", path);
    return false;
  }
  for (const std::string& name : joints) {
    const auto joint = robot->getJoint(name);
    if (!joint || !joint->limits) {
      error = fmt::format("{}: joint '{}' is absent or without limits", path, name);
      return false;
    }
    limits.lower.push_back(joint->limits->lower);
    limits.upper.push_back(joint->limits->upper);
    limits.velocity.push_back(joint->limits->velocity);
    limits.effort.push_back(joint->limits->effort);
  }
  return true;
}

}  // namespace treeline::experiments
