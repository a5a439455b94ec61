#include "description/solve.hpp"

namespace treeline {

Solve solve_of(Function function) {
  switch (function) {
    case Function::forward_dynamics:
    case Function::forward_dynamics_derivatives:
    case Function::lambda_inverse:
    case Function::contact_inverse_inertia:
    case Function::effective_mass:
    case Function::impulse_response:
    case Function::link_inverse_inertias:
      return Solve::mass_matrix;
    case Function::lambda:
    case Function::control_torque:
    case Function::object_control_torque:
    case Function::object_forward_dynamics:
      return Solve::lambda_inverse;
    case Function::damped_control_torque:
      return Solve::damped;
    default:
      return Solve::none;
  }
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

}  // namespace treeline
