#include "measure.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "interpreter/damped_torque.hpp"
#include "interpreter/instances.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/entries.hpp"
#include "oracle/interpret.hpp"
#include "oracle/reference.hpp"
#include "oracle/result_sizes.hpp"
#include "passes/passes.hpp"
#include "program/evaluate.hpp"
#include "recursion/routes/trace_function.hpp"

namespace treeline::stress {
namespace {

using interpreter::Digits50;
using Entries = std::vector<double>;
using DoubleSubject = Subject<double>;

/// A solve with this condition number keeps no digit, and a condition number of this size computed
/// in double is itself unknown.
constexpr double kSingular = 0x1p46;

interpreter::Vector<double> vector_of(const Entries& entries) {
  return interpreter::Vector<double>::Map(entries.data(),
                                          static_cast<Eigen::Index>(entries.size()));
}

Entries entries_of(const interpreter::Matrix<double>& matrix) {
  return {matrix.data(), matrix.data() + matrix.size()};
}

Entries evaluate_graph(const Program& program, const State& state) {
  std::vector<Entries> arguments;
  for (const auto* argument : arguments_of(program, state)) arguments.push_back(*argument);
  Entries flat;
  for (const auto& result : evaluate<double>(program, arguments)) {
    flat.insert(flat.end(), result.begin(), result.end());
  }
  return flat;
}

std::string algorithm_of(const Program& program) {
  return program.route.algorithm_words;
}

/// Algorithms of the interpreter other than the one that `interpret` uses.
std::map<std::string, Entries> other_algorithms(Function function, const DoubleSubject& subject,
                                                const State& state) {
  const auto q = vector_of(state.q);
  if (function == Function::forward_dynamics) {
    return {
        {"interpreter: M by LDL^T", entries_of(interpreter::forward_dynamics_by_mass_matrix<double>(
                                        subject.model, q, vector_of(state.qd), vector_of(state.tau),
                                        {}, interpreter::Vector<double>()))}};
  }
  return {};
}

std::string interpreter_name(Function function) {
  switch (function) {
    case Function::inverse_dynamics:
      return "interpreter: table 4.1";
    case Function::forward_dynamics:
      return "interpreter: table 4.2";
    case Function::lambda_inverse:
    case Function::lambda:
      return "interpreter: table 5.3";
    case Function::control_torque:
      return "interpreter: table 6.1";
    default:
      return "interpreter";
  }
}

}  // namespace

struct Bench::Impl {
  Impl(const Case& of, std::vector<Function> asked, bool graphs)
      : functions(std::move(asked)),
        exact(make_subject<Digits50>(of.robot, of.scene)),
        space{cast<double>(exact), {}, 1, false} {
    const Mechanism mechanism = reduced_mechanism(of.robot, of.scene);
    space.coordinates = mechanism.coordinates;
    for (const Function function : functions) {
      if (!graphs) continue;
      for (const Program& program : trace_function(mechanism, function)) {
        routes[function].push_back(canonicalize(program));
      }
    }
  }

  std::vector<Loss> measure(Function function, const State& state, const ResultSizes& sizes) const {
    FunctionReference reference;
    reference.condition = sizes.conditions(function).largest();
    for (const Digits50& x : interpret<Digits50>(function, exact, state)) {
      reference.high.push_back(static_cast<double>(x));
      reference.low.push_back(static_cast<double>(Digits50(x - Digits50(reference.high.back()))));
    }
    reference.size = sizes.sizes(function, reference.high);
    std::map<std::string, double> worst;  // of an algorithm's routes
    const auto note = [&](const std::string& name, const Entries& result) {
      const double error = error_in_ulp(result, reference, unit_of(Real::float64));
      worst[name] = std::max(worst[name], error);
    };
    note(interpreter_name(function), interpret<double>(function, space.subject, state));
    for (const auto& [name, result] : other_algorithms(function, space.subject, state)) {
      note(name, result);
    }
    if (const auto found = routes.find(function); found != routes.end()) {
      for (const Program& route : found->second) {
        note("graph: " + algorithm_of(route), evaluate_graph(route, state));
      }
    }
    std::vector<Loss> losses;
    for (const auto& [name, error] : worst) {
      const double ratio = reference.condition < kSingular ? error / reference.condition : 0;
      losses.push_back({function, name, error, reference.condition, ratio});
    }
    return losses;
  }

  std::vector<Function> functions;
  Subject<Digits50> exact;
  StateSpace space;
  std::map<Function, std::vector<Program>> routes;
};

Bench::Bench(const Case& of, std::vector<Function> functions, bool graphs)
    : impl_(std::make_unique<Impl>(of, std::move(functions), graphs)) {}
Bench::~Bench() = default;
Bench::Bench(Bench&&) noexcept = default;

State Bench::draw(int index) const {
  int at = 0;
  for (int found = -1;; ++at) {
    found += class_of_state(at) == StateClass::random ? 1 : 0;
    if (found == index) return draw_state(impl_->space, at);
  }
}

std::vector<Loss> Bench::measure(const State& state) const {
  const ResultSizes sizes(impl_->space.subject, state);
  std::vector<Loss> losses;
  for (const Function function : impl_->functions) {
    const auto own = impl_->measure(function, state, sizes);
    losses.insert(losses.end(), own.begin(), own.end());
  }
  return losses;
}

std::vector<Loss> Bench::measure(int states, const std::function<void(State&)>& change) const {
  std::vector<Loss> worst;
  for (int i = 0; i < states; ++i) {
    State state = draw(i);
    if (change) change(state);
    const std::vector<Loss> losses = measure(state);
    if (worst.empty()) worst = losses;
    for (std::size_t k = 0; k < losses.size(); ++k) {
      worst[k].error = std::max(worst[k].error, losses[k].error);
      worst[k].condition = std::max(worst[k].condition, losses[k].condition);
      worst[k].ratio = std::max(worst[k].ratio, losses[k].ratio);
    }
  }
  return worst;
}

bool Bench::damped_torque_is_bounded(const State& state) const {
  const auto& model = impl_->space.subject.model;
  const auto& points = impl_->space.subject.points;
  const auto q = vector_of(state.q);
  const auto none = interpreter::Vector<double>::Zero(model.nv).eval();
  const auto command = vector_of(state.xdd_cmd);
  const auto mass_limits = interpreter::Vector<double>::Constant(command.size(), 100.0).eval();
  const auto M = interpreter::mass_matrix<double>(model, q).ldlt();
  const interpreter::Vector<double> tau = interpreter::damped_control_torque<double>(
                                              model, points, q, none, none, command, {mass_limits})
                                              .tau -
                                          interpreter::gravity<double>(model, q);
  return tau.allFinite() && tau.dot(M.solve(tau)) <= 1.362 * 100 * command.squaredNorm() + 1e-6;
}

double digits_left(double error_in_ulp) {
  if (!(error_in_ulp < 0x1p52)) return 0;
  return std::min(16.0, -std::log10(std::max(error_in_ulp, 0.25) * 0x1p-52));
}

}  // namespace treeline::stress
