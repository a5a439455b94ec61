#include "oracle/interpreted_robot.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "choice/evaluate_damped.hpp"
#include "choice/for_each_index.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/interpret.hpp"
#include "oracle/subject_at.hpp"
#include "recursion/routes/trace_function.hpp"

namespace treeline {
namespace {

/// States that are worth threads of their own.
constexpr std::size_t kManyStates = 256;

InterpretedFunction describe_program(Function function, const Program& program) {
  InterpretedFunction described{function, program.equation, program.arguments, {}, program.law};
  for (const Result& result : program.results) described.results.push_back(result.argument);
  return described;
}

bool yields(const Program& program) {
  return program.law != nullptr;
}

State state_of(const InterpretedFunction& function, const double* numbers) {
  State state;
  for (const Argument& argument : function.arguments) {
    const double* const end = numbers + argument.rows * argument.cols;
    place_of(state, *find_quantity(argument.name)).assign(numbers, end);
    numbers = end;
  }
  return state;
}

std::vector<double> interpret_at(const InterpretedFunction& function,
                                 const Subject<double>& subject, const State& state) {
  const GivenTools tools{values_of(state, Quantity::tool),
                         values_of(state, Quantity::tool_orientation)};
  const auto law = interpreter::cast<double>(law_at(function.law.get(), state.q, tools));
  return interpret<double>(function.function, *SubjectAt<double>(subject, state), state, law);
}

}  // namespace

std::size_t count_numbers(const std::vector<Argument>& list) {
  return std::accumulate(list.begin(), list.end(), std::size_t{0},
                         [](std::size_t sum, const Argument& argument) {
                           return sum + static_cast<std::size_t>(argument.rows * argument.cols);
                         });
}

InterpretedRobot::InterpretedRobot(const Robot& robot, const Scene& scene)
    : options_(route_options(scene)),
      mechanisms_(robot, scene),
      subject_(make_subject<double>(robot, scene, &mechanism())),
      functions_(scene.functions) {
  options_.sin_cos = Sines::computed;
  if (scene.damped) functions_.push_back(Function::damped_control_torque);
}

/// Algorithms differ in the axes in which rows yield, and in nothing else that results show: only
/// where rows yield has the one to be found that is emitted.
GeneratedFunction InterpretedRobot::trace(Function function) {
  const Mechanism& mechanism = mechanisms_.of(function);
  std::vector<Program> programs = trace_function(mechanism, function);
  if (std::any_of(programs.begin(), programs.end(), yields)) {
    return generate_function(mechanism, function, options_);
  }
  return generated_from(function, std::move(programs.front()));
}

const InterpretedFunction& InterpretedRobot::describe(Function function) {
  const auto known = described_.find(function);
  if (known != described_.end()) return known->second;
  if (function != Function::damped_control_torque) {
    const GeneratedFunction traced = trace(function);
    return described_[function] = describe_program(function, traced.program);
  }
  std::vector<GeneratedFunction> parts;
  for (const Function part : kDampedFunctions) parts.push_back(trace(part));
  return described_[function] = describe_program(function, compose_damped(parts).program);
}

std::vector<double> InterpretedRobot::call(const InterpretedFunction& function, std::size_t states,
                                           const std::vector<double>& arguments) const {
  const std::size_t inputs = count_numbers(function.arguments);
  const std::size_t outputs = count_numbers(function.results);
  std::vector<double> results(states * outputs);
  const auto compute = [&](std::size_t i) {
    const State state = state_of(function, arguments.data() + i * inputs);
    const std::vector<double> entries = interpret_at(function, subject_, state);
    if (entries.size() != outputs) throw std::logic_error("results of another size than traced");
    std::copy(entries.begin(), entries.end(), results.data() + i * outputs);
  };
  for_each_index(states, compute, states < kManyStates ? 1 : 0);
  return results;
}

}  // namespace treeline
