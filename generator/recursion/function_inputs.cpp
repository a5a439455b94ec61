#include "recursion/function_inputs.hpp"

namespace treeline {

unsigned inputs_of(Function function) {
  switch (function) {
    case Function::bias_acceleration:
    case Function::nonlinear_effects:
      return kQd;
    case Function::inverse_dynamics:
      return kQd | kQdd | kForces;
    case Function::forward_dynamics:
      return kQd | kTau | kForces;
    case Function::control_torque:
      return kQd | kPosture | kXddCmd | kForces;
    default:
      return 0;
  }
}

}  // namespace treeline
