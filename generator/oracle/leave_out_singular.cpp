#include "oracle/leave_out_singular.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "description/check_scene.hpp"
#include "description/scene_queries.hpp"
#include "text/suggest_name.hpp"

namespace treeline {
namespace {

constexpr std::size_t kMostNamed = 6;

void append_new(const std::string& name, std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

std::string describe_fault(const char* where, const std::vector<MasslessDirections>& all) {
  std::vector<std::string> names;
  for (const MasslessDirections& each : all) names.push_back(each.what);
  return fmt::format("the mass matrix is singular {}: no inertia resists {}", where,
                     list_first(names, kMostNamed));
}

std::string describe_cure(const std::vector<MasslessDirections>& all) {
  std::vector<std::string> links, locks;
  bool base = false;
  for (const MasslessDirections& each : all) {
    append_new(fmt::format("\"{}\"", each.links.front()), links);
    if (each.one_degree) append_new(fmt::format("\"{}\"", each.joint), locks);
    base = base || each.moves_base;
  }
  std::string cure = fmt::format("Give link{} {} mass and moments of inertia in the robot's file",
                                 links.size() > 1 ? "s" : "", list_first(links, kMostNamed));
  if (!locks.empty()) {
    cure += fmt::format("; or lock joint{} {} in the scene", locks.size() > 1 ? "s" : "",
                        list_first(locks, kMostNamed));
  }
  return cure + (base ? "; or write base: fixed" : "");
}

std::vector<std::string> names_of(const std::vector<Function>& functions) {
  std::vector<std::string> names;
  for (const Function function : functions) names.emplace_back(function_name(function));
  return names;
}

/// Whether it is one of the command line, which is in no file.
bool is_option(const std::string& element) {
  return element.rfind("--", 0) == 0;
}

/// The functions that invert M, of those given.
std::vector<Function> inverting(std::vector<Function> functions) {
  std::erase_if(functions, [](Function function) { return !inverts_mass_matrix(function); });
  return functions;
}

/// Warns of the pose in which most robots are started.
void warn_of_zero(const Robot& robot, const Scene& scene, const std::vector<Function>& functions,
                  Diagnostics& diagnostics) {
  const std::vector<MasslessDirections> massless = find_massless_at_zero(robot, scene);
  if (massless.empty()) return;
  diagnostics.add({Severity::warning, file_of_scene(scene, robot), 0, "",
                   fmt::format("{}; without a value there, and with few digits nearby: {}",
                               describe_fault("where all coordinates are 0", massless),
                               list_first(names_of(functions), kMostNamed)),
                   describe_cure(massless) + "; or start from another pose"});
}

}  // namespace

void leave_out_singular(const Robot& robot, Scene& scene, const std::string& listed,
                        Diagnostics& diagnostics) {
  const bool by_name = !listed.empty();
  const std::vector<Function> undefined =
      inverting(by_name ? scene.functions : default_functions(robot, scene));
  if (undefined.empty()) return;
  const std::vector<MasslessDirections> massless = find_massless_directions(robot, scene);
  if (massless.empty()) {
    warn_of_zero(robot, scene, undefined, diagnostics);
    return;
  }
  const std::vector<std::string> names = names_of(undefined);
  const bool asked = by_name || scene.damped || scene.has_limits();
  const char* const composed = scene.damped ? "damped" : "limited_control_torque";
  const std::string list = asked && !by_name ? composed : list_first(names, kMostNamed);
  diagnostics.add(
      {asked ? Severity::error : Severity::warning,
       is_option(listed) ? "" : file_of_scene(scene, robot), 0, listed,
       fmt::format("{}; {} {}", describe_fault("in every pose", massless),
                   asked ? "there is no" : "left out:", list),
       describe_cure(massless) + (by_name ? "; or do not ask for these functions" : "")});
  std::erase_if(scene.functions, inverts_mass_matrix);
}

bool has_accelerations(const Robot& robot, const Scene& scene, Diagnostics& diagnostics) {
  const std::vector<MasslessDirections> massless = find_massless_directions(robot, scene);
  if (massless.empty()) return true;
  diagnostics.add({Severity::error, file_of_scene(scene, robot), 0, "",
                   describe_fault("in every pose", massless) + "; nothing can be simulated",
                   describe_cure(massless)});
  return false;
}

void require_accelerations(const Robot& robot, const Scene& scene, Diagnostics& diagnostics) {
  if (!has_accelerations(robot, scene, diagnostics)) return;
  warn_of_zero(robot, scene, inverting(scene.functions), diagnostics);
}

}  // namespace treeline
