#include <algorithm>
#include <stdexcept>

#include "choice/evaluate_damped.hpp"

namespace treeline {
namespace {

const Program& find_program(const std::vector<GeneratedFunction>& functions, Function function) {
  const auto found =
      std::find_if(functions.begin(), functions.end(),
                   [&](const GeneratedFunction& each) { return each.function == function; });
  if (found == functions.end()) {
    throw std::logic_error(std::string("damped lacks ") + function_name(function));
  }
  return found->program;
}

Result result_like(const Argument& argument) {
  const auto size = static_cast<std::size_t>(argument.rows * argument.cols);
  return {argument, std::vector<Expression>(size)};
}

}  // namespace

GeneratedFunction compose_damped(const std::vector<GeneratedFunction>& functions) {
  const Program& inverse_dynamics = find_program(functions, Function::inverse_dynamics);
  const Program& bias = find_program(functions, Function::bias_acceleration);
  GeneratedFunction composed;
  composed.function = Function::damped_control_torque;
  composed.chosen.route = {"damped", "directions that feel too heavy yield, see damped_solve.hpp"};
  composed.rounding.missing = "it divides by inertias";
  Program& program = composed.program;
  program.name = function_name(composed.function);
  for (Argument argument : inverse_dynamics.arguments) {
    const bool is_posture = argument.name == symbol_of(Quantity::qdd);
    if (is_posture) argument.name = symbol_of(Quantity::qdd_0);
    program.arguments.push_back(argument);
    if (is_posture) {
      program.arguments.push_back(
          {symbol_of(Quantity::xdd_cmd), bias.results.front().argument.rows, 1, ""});
    }
  }
  for (const Function function : kDampedFunctions) {
    for (const Argument& argument : find_program(functions, function).arguments) {
      const auto quantity = find_quantity(argument.name);
      const bool is_new =
          std::none_of(program.arguments.begin(), program.arguments.end(),
                       [&](const Argument& own) { return own.name == argument.name; });
      if (quantity && is_of_model(*quantity) && is_new) program.arguments.push_back(argument);
    }
  }
  program.results = {result_like(inverse_dynamics.results.front().argument),
                     result_like({"ease", 1, 1, "least ease, returned"})};
  return composed;
}

}  // namespace treeline
