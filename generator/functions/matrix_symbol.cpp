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

}  // namespace treeline
