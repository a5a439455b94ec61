#include "check/add_selftest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "choice/for_each_index.hpp"
#include "emission/selftest_facts.hpp"
#include "oracle/bound.hpp"
#include "oracle/reference_maker.hpp"

namespace treeline {
namespace {

/// States that are drawn beyond those that are asked for: their errors widen the bounds, and one
/// takes the place of another in which a function has no value.
constexpr int kSpare = 6;

constexpr std::uint64_t kSelftestSeed = 1;

void shorten_all(std::vector<double>& numbers) {
  for (double& number : numbers) number = shorten(number);
}

/// The state with numbers of few digits, which do not depend on the machine that draws it.
/// Quaternions keep their length.
State shorten_state(State state, const StateSpace& space) {
  for (std::size_t i = 0; i < state.q.size(); ++i) {
    if (!space.coordinates[i].is_of_quaternion()) state.q[i] = shorten(state.q[i]);
  }
  for (auto* numbers : {&state.qd, &state.qdd, &state.tau, &state.xdd_cmd, &state.f_ext}) {
    shorten_all(*numbers);
  }
  for (auto& [quantity, numbers] : state.others) {
    if (quantity != Quantity::tool_orientation) shorten_all(numbers);
  }
  for (std::size_t i = 0; i < state.q.size(); ++i) {
    const auto angle = static_cast<long double>(state.q[i]);
    const auto rounded = [&](long double x) {
      return space.single_precision ? static_cast<double>(static_cast<float>(x))
                                    : static_cast<double>(x);
    };
    state.sin_q[i] = rounded(std::sin(angle));
    state.cos_q[i] = rounded(std::cos(angle));
  }
  return state;
}

std::vector<StateReference> refer_to_states(const Robot& robot, const Scene& scene,
                                            const Generation& generation) {
  const StateSpace space =
      make_state_space(robot, scene, generation.mechanism, generation.functions, kSelftestSeed);
  const ReferenceMaker maker(robot, scene, generation, kSelftestSeed);
  std::vector<int> indices;
  for (int i = 0; std::ssize(indices) < scene.selftest + kSpare; ++i) {
    if (class_of_state(i) == StateClass::random) indices.push_back(i);
  }
  std::vector<StateReference> references(indices.size());
  for_each_index(indices.size(), [&](std::size_t i) {
    references[i] = maker.make(shorten_state(draw_state(space, indices[i]), space));
  });
  return references;
}

/// Whether the function has a value in the state, and the graph gives it within its bound.
bool has_value(const FunctionReference& at, const Bound& bound, double unit) {
  return !at.singular && !at.graph.empty() && are_finite(at.graph) &&
         error_in_ulp(at.graph, at, unit) <= bound.at(at);
}

/// Splits what a function gives into its results.
void add_results(const Program& program, const std::vector<double>& entries,
                 SelftestFacts::Called& called) {
  std::size_t at = 0;
  called.results.resize(program.results.size());
  for (std::size_t i = 0; i < program.results.size(); ++i) {
    const Argument& argument = program.results[i].argument;
    const auto size =
        static_cast<std::size_t>(argument.rows) * static_cast<std::size_t>(argument.cols);
    called.results[i].name = argument.name;
    called.results[i].by_state.emplace_back(
        entries.begin() + static_cast<std::ptrdiff_t>(at),
        entries.begin() + static_cast<std::ptrdiff_t>(at + size));
    at += size;
  }
}

/// Notes what the functions take and give in the states.
void note_calls(const std::vector<GeneratedFunction>& functions,
                const std::vector<const StateReference*>& states,
                const std::set<std::size_t>& without_value, SelftestFacts& facts) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const Program& program = functions[i].program;
    if (without_value.contains(i)) {
      facts.left_out.push_back(program.name + " (no value in any state)");
      continue;
    }
    SelftestFacts::Called& called = facts.functions.emplace_back();
    called.function = program.name;
    for (const StateReference* each : states) {
      add_results(program, each->functions[i].graph, called);
    }
    for (const Argument& argument : program.arguments) {
      if (!seen.insert(argument.name).second) continue;
      SelftestFacts::Values& values = facts.arguments.emplace_back();
      values.name = argument.name;
      for (const StateReference* each : states) {
        values.by_state.push_back(values_of(each->state, *find_quantity(argument.name)));
      }
    }
  }
}

bool complain_of_states(const Scene& scene, const std::string& function, Diagnostics& diagnostics) {
  diagnostics.add({Severity::error, scene.file, 0, "selftest",
                   fmt::format("{} is within its bound of 50 digits in fewer states than are asked "
                               "for",
                               function),
                   "Look at it with `treeline check`, ask for fewer states, or leave it out."});
  return false;
}

/// Chooses states in which all functions that have a value at all have one.
bool choose_states(const Robot& robot, const Scene& scene, const Generation& generation,
                   SelftestFacts& facts, Diagnostics& diagnostics) {
  const auto references = refer_to_states(robot, scene, generation);
  const double unit = unit_of(scene.real);
  std::vector<const StateReference*> states;
  for (const StateReference& each : references) states.push_back(&each);
  std::set<std::size_t> without_value;
  for (std::size_t i = 0; i < generation.functions.size(); ++i) {
    const Bound bound = find_bound(i, generation.functions[i].function, references);
    if (std::all_of(references.begin(), references.end(),
                    [&](const StateReference& each) { return each.functions[i].singular; })) {
      without_value.insert(i);
      continue;
    }
    std::erase_if(states, [&](const StateReference* each) {
      return !has_value(each->functions[i], bound, unit);
    });
    if (std::ssize(states) < scene.selftest) {
      return complain_of_states(scene, generation.functions[i].program.name, diagnostics);
    }
  }
  states.resize(static_cast<std::size_t>(scene.selftest));
  note_calls(generation.functions, states, without_value, facts);
  return true;
}

/// The functions of one state, of which alone there are references here.
Generation keep_plain(const Generation& generation) {
  Generation plain = generation;
  plain.batch.clear();
  plain.damped.reset();
  return plain;
}

}  // namespace

double shorten(double number) {
  constexpr double kSteps = 0x1p20;
  int exponent = 0;
  const double fraction = std::frexp(number, &exponent);
  return std::ldexp(std::round(fraction * kSteps) / kSteps, exponent);
}

bool add_selftest(const Robot& robot, const Scene& scene, Generation& generation,
                  Diagnostics& diagnostics) {
  if (scene.selftest == 0) return true;
  auto facts = std::make_shared<SelftestFacts>();
  facts->states = scene.selftest;
  if (!generation.functions.empty() &&
      !choose_states(robot, scene, keep_plain(generation), *facts, diagnostics)) {
    return false;
  }
  for (const GeneratedFunction& generated : generation.batch) {
    facts->left_out.push_back(source_stem(generated));
  }
  if (generation.damped) facts->left_out.push_back(generation.damped->program.name);
  if (scene.has_limits()) facts->left_out.emplace_back("limited_control_torque");
  if (generation.controller) {
    facts->motion = record_selftest_motion(robot, scene, generation, diagnostics);
    if (!facts->motion) return false;
  }
  if (facts->functions.empty() && !facts->motion) {
    diagnostics.add({Severity::error, scene.file, 0, "selftest",
                     "the code has no function that a self-test could call",
                     "List functions, or leave out `selftest`."});
    return false;
  }
  emit_with_selftest(std::move(facts), generation);
  return true;
}

}  // namespace treeline
