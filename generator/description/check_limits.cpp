
#include <fmt/format.h>

#include <algorithm>

#include "description/check_scene.hpp"

namespace treeline {
namespace {

bool has(const Scene& scene, Function function) {
  return std::count(scene.functions.begin(), scene.functions.end(), function) > 0;
}

}  // namespace

const char* why_unsupported(const Scene& scene) {
  return scene.operational_points.empty() ? "nothing is held, and there is no operational point"
                                          : "nothing is held, and every joint has a motor";
}

std::vector<Function> functions_of_limits(const Scene& scene) {
  std::vector<Function> functions = {Function::mass_matrix, Function::supported_control_torque};
  if (!scene.operational_points.empty()) functions.push_back(Function::jacobian);
  if (scene.holds_rows()) functions.push_back(Function::constraint_jacobian);
  return functions;
}

void add_functions_of_limits(const Robot& robot, Scene& scene) {
  if (!scene.has_limits()) return;
  for (const Function function : functions_of_limits(scene)) {
    if (!permits(robot, scene, function) || has(scene, function)) continue;
    scene.functions.push_back(function);
  }
  std::sort(scene.functions.begin(), scene.functions.end());
}

void check_limits(const SceneElement& top, const Robot& robot, const Scene& scene) {
  if (!scene.has_limits()) return;
  const char* const key = scene.torque_limits.empty() ? "friction" : "torque_limits";
  if (!permits(robot, scene, Function::supported_control_torque)) {
    top.error(fmt::format("{} limits the law of supported_control_torque, which this scene cannot "
                          "have: {}",
                          key, why_unsupported(scene)),
              "add constraints; or operational_points, and passive joints where nothing floats; or "
              "remove "
              "the limits");
    return;
  }
  for (const Function function : functions_of_limits(scene)) {
    if (has(scene, function)) continue;
    top.error(
        fmt::format("{} needs {}, which is not among the functions", key, function_name(function)),
        "add it to functions, or leave out functions for all");
    return;
  }
}

}  // namespace treeline
