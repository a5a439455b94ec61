#include "oracle/reference_maker.hpp"

#include <cmath>
#include <utility>

#include "choice/evaluate_damped.hpp"
#include "oracle/entries.hpp"
#include "oracle/interpret.hpp"
#include "oracle/subject_at.hpp"

namespace treeline {
namespace {

using interpreter::Digits50;

/// Share of 1/unit above which a condition number leaves a solve no correct digit to compare.
constexpr double kSingular = 1.0 / 64;

void split(const std::vector<Digits50>& exact, FunctionReference& reference) {
  for (const Digits50& x : exact) {
    const auto high = static_cast<double>(x);
    reference.high.push_back(high);
    reference.low.push_back(static_cast<double>(Digits50(x - Digits50(high))));
  }
}

/// Largest remainder of a sum whose terms cancel, in 50 digits, in SI units.
constexpr double kCancelled = 1e-30;

/// Makes entries 0 that have no term, as their size of 0 says, in the reference and in the
/// interpreter's result: the formulation of the interpreter has terms there that cancel.
void clear_residues(FunctionReference& reference, std::vector<double>& in_real) {
  for (std::size_t i = 0; i < reference.size.size(); ++i) {
    if (reference.size[i] != 0 || !(std::abs(reference.high[i]) < kCancelled)) continue;
    reference.high[i] = reference.low[i] = in_real[i] = 0;
  }
}

template <class T>
std::vector<double> widened(const std::vector<T>& entries) {
  return {entries.begin(), entries.end()};
}

}  // namespace

ReferenceMaker::ReferenceMaker(const Robot& robot, const Scene& scene,
                               const ChosenFunctions& chosen, std::uint64_t seed)
    : functions_(all_callable(chosen)),
      plain_(chosen.functions.size()),
      real_(scene.real),
      exact_(make_subject<Digits50>(robot, scene, &chosen.mechanism)),
      single_(cast<float>(exact_)),
      space_(make_state_space(robot, scene, chosen.mechanism, functions_, seed)) {
  space_.subject = cast<double>(exact_);
  for (const GeneratedFunction& generated : functions_) {
    runs_.emplace_back(generated.program);
    size_laws_.push_back(law_of_sizes(generated.program.law));
  }
}

StateReference ReferenceMaker::make(int index) const {
  return make(draw_state(space_, index));
}

StateReference ReferenceMaker::make(State state) const {
  return make(std::move(state), Digits::fifty);
}

StateReference ReferenceMaker::estimate(int index) const {
  return make(draw_state(space_, index), Digits::in_real);
}

void ReferenceMaker::complete(std::size_t i, const State& state,
                              FunctionReference& estimated) const {
  const std::size_t like = shares_reference(i) ? i - plain_ : i;
  const SubjectAt subject(space_.subject, state);
  const ResultSizes sizes(*subject, state);
  FunctionReference made = interpret_at(like, state, sizes, Digits::fifty);
  made.graph = std::move(estimated.graph);
  made.computed_angles = estimated.computed_angles;
  estimated = std::move(made);
}

/// Whether function `i` is a batch with the reference of the plain function before it. Its graph
/// may be by another route. Where rows of a task are relaxed, they are relaxed in the axes of the
/// route.
bool ReferenceMaker::shares_reference(std::size_t i) const {
  if (functions_[i].batch == 0) return false;
  const GeneratedFunction& plain = functions_[i - plain_];
  return functions_[i].program.law == nullptr ||
         key_of(functions_[i].chosen.route) == key_of(plain.chosen.route);
}

StateReference ReferenceMaker::make(State state, Digits digits) const {
  StateReference made{std::move(state), {}};
  const SubjectAt subject(space_.subject, made.state);
  const ResultSizes sizes(*subject, made.state);
  for (std::size_t i = 0; i < functions_.size(); ++i) {
    made.functions.push_back(shares_reference(i) ? made.functions[i - plain_]
                                                 : interpret_at(i, made.state, sizes, digits));
    FunctionReference& reference = made.functions.back();
    if (is_composed(functions_[i])) {
      compose_graph(made);
      continue;
    }
    reference.graph = runs_[i].results(made.state, real_);
    reference.computed_angles = runs_[i].computed_angles(made.state);
  }
  return made;
}

/// Computes the result that the last function must have, which is composed of other functions of
/// the same state. Rounding of an angle in one of these is amplified like their errors.
void ReferenceMaker::compose_graph(StateReference& made) const {
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
  inputs.mass_limits = entries_of(space_.subject.damping.effective_mass_limits);
  composed.graph = evaluate_damped(real_, inputs);
}

FunctionReference ReferenceMaker::interpret_at(std::size_t i, const State& state,
                                               const ResultSizes& sizes, Digits digits) const {
  const Function function = functions_[i].function;
  const GivenTools tools{values_of(state, Quantity::tool),
                         values_of(state, Quantity::tool_orientation)};
  const auto law = law_at(functions_[i].program.law.get(), state.q, tools);
  const auto size_law = interpreter::cast<double>(law_at(size_laws_[i].get(), state.q, tools));
  FunctionReference reference;
  const auto relaxed = sizes.relaxed(function, size_law);
  const Conditions conditions = sizes.conditions(function, relaxed);
  reference.condition = conditions.largest();
  reference.amplification = conditions.amplification();
  // If rows are relaxed, every state has a reference, however fast the result changes there, unless
  // M itself is singular.
  const bool relaxes =
      size_laws_[i] != nullptr && std::isfinite(reference.condition) && is_regular(sizes);
  reference.singular = !relaxes && !(reference.condition < kSingular / unit_of(real_));
  if (reference.singular) {
    reference.stays_finite = stays_finite(function, state, sizes, law);
    return reference;
  }
  std::vector<double> in_real = interpret_in_real(function, state, law);
  if (digits == Digits::in_real) {
    reference.low.assign(in_real.size(), 0);
    reference.high = std::move(in_real);
    reference.size = sizes.sizes(function, reference.high, size_law, relaxed);
    return reference;
  }
  split(interpret<Digits50>(function, *SubjectAt(exact_, state), state, law), reference);
  reference.size = sizes.sizes(function, reference.high, size_law, relaxed);
  clear_residues(reference, in_real);
  reference.border_steps = sizes.border_steps(function, unit_of(real_));
  reference.interpreter_error = error_in_ulp(in_real, reference, unit_of(real_));
  return reference;
}

/// Whether a solve with M leaves digits in Real.
bool ReferenceMaker::is_regular(const ResultSizes& sizes) const {
  return sizes.conditions(Function::forward_dynamics).largest() < kSingular / unit_of(real_);
}

/// Whether the result must be finite. It must if rows are relaxed and the robot itself is not
/// singular; this is checked where the interpreter's result in Real is finite.
bool ReferenceMaker::stays_finite(Function function, const State& state, const ResultSizes& sizes,
                                  const interpreter::TaskLaw<Digits50>& law) const {
  return !law.borders.empty() && is_regular(sizes) &&
         are_finite(interpret_in_real(function, state, law));
}

std::vector<double> ReferenceMaker::interpret_in_real(
    Function function, const State& state, const interpreter::TaskLaw<Digits50>& law) const {
  return real_ == Real::float32 ? widened(interpret<float>(function, *SubjectAt(single_, state),
                                                           state, interpreter::cast<float>(law)))
                                : interpret<double>(function, *SubjectAt(space_.subject, state),
                                                    state, interpreter::cast<double>(law));
}

}  // namespace treeline
