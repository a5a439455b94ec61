#include "cli/simulated_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "text/identifier.hpp"

namespace treeline {
namespace {

constexpr const char* kHeldElsewhere =
    "leave it out of a copy, and the robot moves as the open tree; constrained_forward_dynamics "
    "holds it in generated code and in treeline.Model";

/// What would change a motion: a key of the scene or an element of the robot's file, and its names.
struct Unheld {
  std::string file;
  const char* key;
  const char* fault;
  const char* remedy;
  std::vector<std::string> names = {};
};

/// A scene names a loop of the robot's file by an identifier.
bool is_of_file(const Robot& robot, const std::string& loop) {
  return std::any_of(robot.loops.begin(), robot.loops.end(),
                     [&](const RobotLoop& each) { return identifier_from(each.name) == loop; });
}

/// Everything that holds or loads a robot and that no step of time obeys.
std::vector<Unheld> list_unheld(const Robot& robot, const Scene& scene) {
  const char* const open = "nothing holds this through time";
  Unheld constraints{scene.file, "constraints", open, kHeldElsewhere};
  Unheld loops{robot.file, "loop_joint", open, kHeldElsewhere};
  Unheld couplings{scene.file, "couplings", open, kHeldElsewhere};
  Unheld objects{scene.file, "objects", "nothing carries this through time",
                 "leave it out; what one hand holds may be mass of the hand's link in a copy of "
                 "the robot's file"};
  for (const ScenePoint& each : scene.constraints) constraints.names.push_back(each.name);
  for (const SceneLoop& each : scene.loops) {
    (is_of_file(robot, each.first.name) ? loops : constraints).names.push_back(each.first.name);
  }
  for (const SceneCoupling& each : scene.couplings) couplings.names.push_back(each.name);
  for (const SceneObject& each : scene.objects) objects.names.push_back(each.name);
  return {constraints, loops, couplings, objects};
}

}  // namespace

void refuse_unheld(const Robot& robot, const Scene& scene, Diagnostics& diagnostics) {
  for (const Unheld& each : list_unheld(robot, scene)) {
    if (each.names.empty()) continue;
    diagnostics.add({Severity::error, each.file, 0,
                     fmt::format("{}[{}]", each.key, fmt::join(each.names, ", ")), each.fault,
                     each.remedy});
  }
}

void note_unsimulated(const Scene& scene, const SceneSurroundings& surroundings,
                      bool has_joint_forces, Diagnostics& diagnostics) {
  const auto note = [&](bool applies, const char* key, const char* fault, const char* remedy) {
    if (applies) diagnostics.add({Severity::note, scene.file, 0, key, fault, remedy});
  };
  note(!surroundings.obstacles.empty(), "obstacles", "the robot moves through them",
       "drive has obstacles that robots touch and avoid");
  note(has_joint_forces && !scene.passive.empty(), "passive",
       "--hold, --stiffness and --damping act in these joints, too", "");
  note(has_joint_forces && !scene.torque_limits.empty(), "torque_limits",
       "they do not limit the forces of --hold, --stiffness and --damping", "");
}

}  // namespace treeline
