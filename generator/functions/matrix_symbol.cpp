#include "functions/matrix_symbol.hpp"

namespace treeline {

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
