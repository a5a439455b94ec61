#include "functions/function.hpp"

namespace treeline {

std::optional<Function> find_function(std::string_view name) {
  for (const Function function : kSceneFunctions) {
    if (name == function_name(function)) return function;
  }
  return std::nullopt;
}

const char* matrix_symbol(Solve solve) {
  switch (solve) {
    case Solve::mass_matrix:
      return "M";
    case Solve::lambda_inverse:
      return "Lambda^-1";
    case Solve::damped:
      return "Lambda^-1 + Delta";
    case Solve::none:
      break;
  }
  return "";
}

std::string matrix_symbols(Solve solve) {
  const bool made_with_M = solve == Solve::lambda_inverse || solve == Solve::damped;
  return std::string(made_with_M ? "M and " : "") + matrix_symbol(solve);
}

}  // namespace treeline
