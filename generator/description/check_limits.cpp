#include "description/check_limits.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "description/check_scene.hpp"

namespace treeline {
namespace {

bool has(const Scene& scene, Function function) {
  return std::count(scene.functions.begin(), scene.functions.end(), function) > 0;
}

}  // namespace

std::vector<Function> functions_of_limits(const Scene& scene) {
  std::vector<Function> functions = {Function::mass_matrix, Function::supported_control_torque};
  if (!scene.operational_points.empty()) functions.push_back(Function::jacobian);
  if (scene.holds_rows()) functions.push_back(Function::constraint_jacobian);
  return functions;
}

void add_functions_of_limits(Scene& scene) {
  if (!scene.has_limits()) return;
  for (const Function function : functions_of_limits(scene)) {
    if (permits(scene, function) && !has(scene, function)) scene.functions.push_back(function);
  }
  std::sort(scene.functions.begin(), scene.functions.end());
}

void check_limits(const SceneElement& top, const Scene& scene) {
  if (!scene.has_limits()) return;
  const char* const key = scene.torque_limits.empty() ? "friction" : "torque_limits";
  if (!permits(scene, Function::supported_control_torque)) {
    top.error(
        fmt::format("{} limits the law of supported_control_torque, which this scene cannot "
                    "have: {}",
                    key, scene.holds_rows() ? kNoTask : "nothing is held, and no joint is passive"),
        "add constraints or passive joints, and operational_points; or remove the limits");
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
