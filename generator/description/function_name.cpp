#include "description/scene.hpp"

namespace treeline {

const char* function_name(Function function) {
  switch (function) {
    case Function::forward_kinematics:
      return "forward_kinematics";
    case Function::jacobian:
      return "jacobian";
    case Function::bias_acceleration:
      return "bias_acceleration";
    case Function::inverse_dynamics:
      return "inverse_dynamics";
    case Function::gravity:
      return "gravity";
    case Function::nonlinear_effects:
      return "nonlinear_effects";
    case Function::mass_matrix:
      return "mass_matrix";
    case Function::forward_dynamics:
      return "forward_dynamics";
    case Function::lambda_inverse:
      return "lambda_inverse";
    case Function::lambda:
      return "lambda";
    case Function::control_torque:
      return "control_torque";
    case Function::object_state:
      return "object_state";
    case Function::object_control_torque:
      return "object_control_torque";
    case Function::object_forward_dynamics:
      return "object_forward_dynamics";
    case Function::contact_motion:
      return "contact_motion";
    case Function::contact_inverse_inertia:
      return "contact_inverse_inertia";
    case Function::effective_mass:
      return "effective_mass";
    case Function::impulse_response:
      return "impulse_response";
    case Function::link_inverse_inertias:
      return "link_inverse_inertias";
    case Function::center_of_mass:
      return "center_of_mass";
    case Function::center_of_mass_jacobian:
      return "center_of_mass_jacobian";
    case Function::inverse_dynamics_derivatives:
      return "inverse_dynamics_derivatives";
    case Function::forward_dynamics_derivatives:
      return "forward_dynamics_derivatives";
    case Function::damped_control_torque:
      return "damped_control_torque";
  }
  return "";
}

}  // namespace treeline
