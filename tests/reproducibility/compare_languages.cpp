#include "reproducibility/compare_languages.hpp"

#include <cstring>
#include <stdexcept>
#include <utility>

#include "check/judges.hpp"
#include "compilation/print_entry.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "generation/describe_limits.hpp"

namespace treeline::tests {
namespace {

[[noreturn]] void fail_with(const Diagnostics& diagnostics, const std::string& what) {
  std::string text = what;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    if (diagnostic.severity == Severity::error) text.append("\n").append(to_string(diagnostic));
  }
  throw std::runtime_error(text);
}

Original generate_in(Language language, const Robot& robot, Scene scene) {
  scene.language = language;
  Diagnostics diagnostics;
  auto generation = generate_code(robot, scene, {"r.urdf", "", "s.yaml", ""}, diagnostics);
  if (!generation) fail_with(diagnostics, robot.name);
  return {robot.name, robot, scene, std::move(*generation), {}};
}

/// Whether all bits are equal; of a NaN only that both are one.
bool have_same_bits(const CallResult& a, const CallResult& b) {
  if (a.entries.size() != b.entries.size() || a.entries.empty()) return false;
  for (std::size_t i = 0; i < a.entries.size(); ++i) {
    const double x = a.entries[i], y = b.entries[i];
    if (x != x && y != y) continue;
    if (std::memcmp(&x, &y, sizeof x) != 0) return false;
  }
  return !a.wrote_out_of_bounds && !b.wrote_out_of_bounds;
}

/// Arrays that the entry of limited_control_torque fills.
std::vector<std::size_t> limited_sizes(const Original& original) {
  const LimitFacts facts = describe_limits(
      original.robot, original.scene, original.generation.mechanism, original.generation.functions);
  const std::size_t motors = facts.torque.size() - facts.passive.size();
  return {facts.torque.size(), facts.force_weights.size(), facts.task_weights.size(), 3,
          motors + facts.cones.size() + 1};
}

}  // namespace

std::vector<LanguageRow> compare_languages(const Robot& robot, const Scene& scene,
                                           const Compilers& compilers, const std::string& flags,
                                           int states) {
  const Original one = generate_in(compilers.language, robot, scene);
  const Original other = generate_in(compilers.other, robot, scene);
  const GeneratedLibrary first = build_library(one, {compilers.first, flags});
  const GeneratedLibrary second = build_library(other, {compilers.second, flags});
  const auto functions = all_callable(one.generation);
  if (functions.size() != all_callable(other.generation).size()) {
    throw std::runtime_error(robot.name + ": one language has other functions than the other");
  }
  const StateSpace space = make_state_space(robot, scene, one.generation.mechanism, functions, 7);
  std::vector<LanguageRow> rows;
  for (std::size_t i = 0; i < functions.size() && scene.has_limits(); ++i) {
    if (functions[i].function != Function::supported_control_torque) continue;
    rows.push_back({scene.name, limited_stem(false), compilers.first + " " + compilers.second,
                    flags, states, 0});
    const auto sizes = limited_sizes(one);
    for (int index = 0; index < states; ++index) {
      const State state = draw_state(space, index);
      const bool same = have_same_bits(
          first.call_entry(first.find_entry(limited_stem(false)), i, state, sizes),
          second.call_entry(second.find_entry(limited_stem(false)), i, state, sizes));
      rows.back().bits_differ += same ? 0 : 1;
    }
  }
  for (std::size_t i = 0; i < functions.size(); ++i) {
    rows.push_back({scene.name, source_stem(functions[i]), compilers.first + " " + compilers.second,
                    flags, states, 0});
    for (int index = 0; index < states; ++index) {
      const State state = draw_state(space, index);
      rows.back().bits_differ +=
          have_same_bits(first.call(i, state), second.call(i, state)) ? 0 : 1;
    }
  }
  return rows;
}

std::vector<LanguageRow> compare_languages_of(const std::string& urdf, const std::string& scene,
                                              const std::vector<Function>& functions, Real real,
                                              int lanes, const Compilers& compilers, int states,
                                              const Manner& manner) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(urdf, diagnostics);
  if (!robot) fail_with(diagnostics, urdf);
  auto read = read_scene(scene, *robot, diagnostics, functions);
  if (!read) fail_with(diagnostics, urdf + " " + scene);
  read->real = real;
  read->lanes = lanes;
  read->batch = manner.batch;
  read->profile = manner.profile;
  return compare_languages(*robot, *read, compilers,
                           std::string(manner.level) + " -ffp-contract=off", states);
}

}  // namespace treeline::tests
