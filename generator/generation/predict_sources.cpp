#include "generation/predict_sources.hpp"

#include "emission/c/hides_header.hpp"
#include "emission/print_identity.hpp"
#include "emission/print_selftest.hpp"
#include "functions/function.hpp"
#include "generation/generate_code.hpp"

namespace treeline {
namespace {

/// Adds the sources in C whose counterparts in C++ are headers.
void append_loops_of_c(const Scene& scene, std::vector<std::string>& stems) {
  if (scene.damped) stems.emplace_back(function_name(Function::damped_control_torque));
  if (!scene.has_limits()) return;
  stems.emplace_back("limited_control_torque");
  if (scene.batch > 0) stems.emplace_back("batch_limited_control_torque");
}

void append_controller(const Scene& scene, std::vector<std::string>& stems) {
  const SceneController& controller = *scene.controller;
  for (const char* stem : {"controller", "controller_kinematics", "controller_joint_torque"}) {
    stems.emplace_back(stem);
  }
  if (scene.optimize == Optimize::size) stems.emplace_back("controller_gravity");
  if (controller.task) stems.emplace_back("controller_task_torque");
  if (controller.task && controller.force) stems.emplace_back("controller_push_torque");
}

}  // namespace

std::vector<std::string> predict_sources(const Scene& scene) {
  std::vector<std::string> stems;
  for (const Function function : scene.functions) {
    stems.push_back(source_stem(function, 0));
    if (scene.batch > 0) stems.push_back(source_stem(function, scene.batch));
  }
  if (scene.language == Language::c) {
    append_loops_of_c(scene, stems);
  } else if (scene.profile != Profile::misra && !c::hides_header(scene.name)) {
    stems.emplace_back("c_calls");
  }
  stems.emplace_back(kIdentityStem);
  if (scene.prefetch) stems.emplace_back("prefetch");
  if (scene.selftest > 0) stems.emplace_back(kSelftestStem);
  if (scene.controller) append_controller(scene, stems);
  return stems;
}

}  // namespace treeline
