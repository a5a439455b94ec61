#include "check/reference.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <future>
#include <limits>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "check/condition.hpp"
#include "check/entries.hpp"
#include "check/evaluate_damped.hpp"
#include "check/interpret.hpp"
#include "check/result_sizes.hpp"
#include "program/evaluate.hpp"

namespace treeline {
namespace {

using interpreter::Digits50;

/// Beyond this share of 1/unit a condition leaves a solve without a digit worth comparing.
constexpr double kSingular = 1.0 / 64;

void split(const std::vector<Digits50>& exact, FunctionReference& reference) {
  for (const Digits50& x : exact) {
    const auto high = static_cast<double>(x);
    reference.high.push_back(high);
    reference.low.push_back(static_cast<double>(Digits50(x - Digits50(high))));
  }
}

template <class T>
std::vector<double> widened(const std::vector<T>& entries) {
  return {entries.begin(), entries.end()};
}

template <class T>
std::vector<double> evaluate_graph(const Program& program, const State& state) {
  std::vector<std::vector<T>> arguments;
  for (const auto* argument : arguments_of(program, state)) {
    std::vector<T>& entries = arguments.emplace_back();
    for (const double entry : *argument) entries.push_back(static_cast<T>(entry));
  }
  std::vector<double> flat;
  for (const auto& result : evaluate<T>(program, arguments)) {
    flat.insert(flat.end(), result.begin(), result.end());
  }
  return flat;
}

/// A program whose results are the angles that `program` takes the sine or cosine of, but for
/// those that are inputs.
Program angles_of(const Program& program) {
  Program angles = program;
  angles.results = {Result{}};
  std::set<std::uint32_t> operands;
  for (const Node& node : program.graph.nodes()) {
    const bool trigonometric = node.op == Op::sin || node.op == Op::cos;
    if (trigonometric && program.graph.nodes()[node.a].op != Op::input) operands.insert(node.a);
  }
  for (const std::uint32_t operand : operands) {
    angles.results.front().values.emplace_back(operand, false);
  }
  return angles;
}

bool is_drawn(const std::string& argument) {
  constexpr std::array kDrawn = {"q",     "sin_q", "cos_q",   "qd",   "qdd",
                                 "qdd_0", "tau",   "xdd_cmd", "f_ext"};
  return std::find(kDrawn.begin(), kDrawn.end(), argument) != kDrawn.end();
}

/// Arguments of functions about contacts and objects; they are drawn without regard to their
/// meaning.
std::map<std::string, int> other_arguments(const std::vector<GeneratedFunction>& functions) {
  std::map<std::string, int> sizes;
  for (const GeneratedFunction& generated : functions) {
    for (const Argument& argument : generated.program.arguments) {
      const int size = argument.rows * argument.cols;
      if (!is_drawn(argument.name)) sizes[argument.name] = std::max(sizes[argument.name], size);
    }
  }
  return sizes;
}

double add_magnitudes(const std::vector<double>& entries) {
  double sum = 0;
  for (const double entry : entries) sum += std::abs(entry);
  return sum;
}

std::vector<int> state_indices(const ReferenceOptions& options) {
  std::vector<int> indices;
  for (int i = options.first; static_cast<int>(indices.size()) < options.states; ++i) {
    if (!options.only || class_of_state(i) == *options.only) indices.push_back(i);
  }
  return indices;
}

class ReferenceMaker {
 public:
  ReferenceMaker(const Robot& robot, const Scene& scene, const Generation& generation,
                 std::uint64_t seed)
      : functions_(all_callable(generation)),
        plain_(generation.functions.size()),
        real_(scene.real),
        exact_(make_subject<Digits50>(robot, scene)),
        single_(cast<float>(exact_)),
        space_{cast<double>(exact_), generation.mechanism.coordinates, seed,
               scene.real == Real::float32, other_arguments(functions_)} {
    for (const GeneratedFunction& generated : functions_) {
      angles_.push_back(angles_of(generated.program));
    }
  }

  StateReference make(int index) const {
    StateReference made{draw_state(space_, index), {}};
    const ResultSizes sizes(space_.subject, made.state);
    for (std::size_t i = 0; i < angles_.size(); ++i) {
      // A function of several states differs from the plain one in its graph, not in its truth.
      made.functions.push_back(functions_[i].batch > 0
                                   ? made.functions[i - plain_]
                                   : find_truth(functions_[i], made.state, sizes));
      if (is_composed(functions_[i])) {
        compose_graph(made);
        continue;
      }
      made.functions.back().graph = evaluate_in_real(functions_[i].program, made.state);
      made.functions.back().computed_angles =
          add_magnitudes(evaluate_graph<double>(angles_[i], made.state));
    }
    return made;
  }

 private:
  /// What must come out of the last function, which is composed of others of the state's; an angle
  /// that one of these rounds is amplified as their errors are.
  void compose_graph(StateReference& made) const {
    FunctionReference& composed = made.functions.back();
    const auto graph_of = [&](Function function) {
      std::size_t i = 0;
      while (functions_[i].function != function) ++i;
      composed.computed_angles += composed.condition * made.functions[i].computed_angles;
      return made.functions[i].graph;
    };
    DampedInputs inputs;
    inputs.Lambda_inverse = graph_of(Function::lambda_inverse);
    inputs.J = graph_of(Function::jacobian);
    inputs.bias = graph_of(Function::bias_acceleration);
    inputs.tau = graph_of(Function::inverse_dynamics);
    inputs.qdd_0 = made.state.qdd;
    inputs.xdd_cmd = made.state.xdd_cmd;
    inputs.heaviest = entries_of(space_.subject.damping.heaviest);
    composed.graph = evaluate_damped(real_, inputs);
  }

  std::vector<double> evaluate_in_real(const Program& program, const State& state) const {
    return real_ == Real::float32 ? evaluate_graph<float>(program, state)
                                  : evaluate_graph<double>(program, state);
  }

  FunctionReference find_truth(const GeneratedFunction& generated, const State& state,
                               const ResultSizes& sizes) const {
    FunctionReference reference;
    reference.condition = sizes.condition(generated.function);
    reference.singular = !(reference.condition < kSingular / unit_of(real_));
    if (reference.singular) return reference;
    split(interpret<Digits50>(generated.function, exact_, state), reference);
    reference.size = sizes.sizes(generated.function, reference.high);
    reference.interpreter_error =
        error_in_ulp(interpret_in_real(generated.function, state), reference, unit_of(real_));
    return reference;
  }

  std::vector<double> interpret_in_real(Function function, const State& state) const {
    return real_ == Real::float32 ? widened(interpret<float>(function, single_, state))
                                  : interpret<double>(function, space_.subject, state);
  }

  std::vector<GeneratedFunction> functions_;
  std::size_t plain_;            ///< so many of them are of one state
  std::vector<Program> angles_;  ///< of each function
  Real real_;
  Subject<Digits50> exact_;
  Subject<float> single_;
  StateSpace space_;
};

}  // namespace

StateSpace make_state_space(const Robot& robot, const Scene& scene, const Mechanism& mechanism,
                            const std::vector<GeneratedFunction>& functions, std::uint64_t seed) {
  return {make_subject<double>(robot, scene), mechanism.coordinates, seed,
          scene.real == Real::float32, other_arguments(functions)};
}

std::vector<StateReference> make_references(const Robot& robot, const Scene& scene,
                                            const Generation& generation,
                                            const ReferenceOptions& options) {
  const ReferenceMaker maker(robot, scene, generation, options.seed);
  std::vector<StateReference> made(static_cast<std::size_t>(options.states));
  const std::vector<int> indices = state_indices(options);
  std::atomic<int> next = 0;
  int done = 0;
  std::mutex telling;
  const auto work = [&] {
    for (int i = next++; i < options.states; i = next++) {
      made[static_cast<std::size_t>(i)] = maker.make(indices[static_cast<std::size_t>(i)]);
      const std::lock_guard lock(telling);
      ++done;
      if (options.progress) options.progress(done, options.states);
    }
  };
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  const unsigned count = options.threads > 0 ? static_cast<unsigned>(options.threads) : cores;
  std::vector<std::future<void>> workers;
  for (unsigned i = 0; i < count; ++i) workers.push_back(std::async(std::launch::async, work));
  for (auto& worker : workers) worker.get();
  return made;
}

double unit_of(Real real) {
  return real == Real::float32 ? 0x1p-23 : 0x1p-52;
}

double error_in_ulp(const std::vector<double>& actual, const FunctionReference& reference,
                    double unit) {
  double worst = 0;
  for (std::size_t i = 0; i < reference.high.size(); ++i) {
    const double difference = (reference.high[i] - actual[i]) + reference.low[i];
    if (difference == 0) continue;
    const double error = std::abs(difference) / (unit * reference.size[i]);
    if (!(error <= std::numeric_limits<double>::max())) {
      return std::numeric_limits<double>::infinity();
    }
    worst = std::max(worst, error);
  }
  return worst;
}

std::vector<const std::vector<double>*> arguments_of(const Program& program, const State& state) {
  std::vector<const std::vector<double>*> arguments;
  for (const Argument& argument : program.arguments) {
    const std::string& name = argument.name;
    if (name == "q") {
      arguments.push_back(&state.q);
    } else if (name == "sin_q") {
      arguments.push_back(&state.sin_q);
    } else if (name == "cos_q") {
      arguments.push_back(&state.cos_q);
    } else if (name == "qd") {
      arguments.push_back(&state.qd);
    } else if (name == "qdd" || name == "qdd_0") {
      arguments.push_back(&state.qdd);
    } else if (name == "tau") {
      arguments.push_back(&state.tau);
    } else if (name == "xdd_cmd") {
      arguments.push_back(&state.xdd_cmd);
    } else if (name == "f_ext") {
      arguments.push_back(&state.f_ext);
    } else {
      arguments.push_back(&state.others.at(name));
    }
  }
  return arguments;
}

}  // namespace treeline
