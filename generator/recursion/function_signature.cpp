#include "recursion/function_signature.hpp"

namespace treeline {

Signature signature(Function function) {
  switch (function) {
    case Function::forward_kinematics:
      return {"x_world = R x_point + p, for every operational point", 0};
    case Function::jacobian:
      return {"xd = J qd, rows stacked over operational points", 0};
    case Function::bias_acceleration:
      return {"xdd = J qdd + Jd qd: the term Jd qd", kQd};
    case Function::inverse_dynamics:
      return {"tau = M qdd + b + g - J_ext^T f_ext", kQd | kQdd | kForces};
    case Function::gravity:
      return {"g: the joint forces that hold the robot at rest", 0};
    case Function::nonlinear_effects:
      return {"h = b + g: the joint forces at qdd = 0", kQd};
    case Function::mass_matrix:
      return {"tau = M qdd + b + g: the matrix M", 0};
    case Function::forward_dynamics:
      return {"qdd = M^-1 (tau - b - g + J_ext^T f_ext)", kQd | kTau | kForces};
    case Function::lambda_inverse:
      return {"Lambda^-1 = J M^-1 J^T", 0};
    case Function::lambda:
      return {"Lambda = (J M^-1 J^T)^-1", 0};
    case Function::control_torque:
      return {
          "tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, "
          "F = Lambda (xdd_cmd - Jd qd - J qdd_0)",
          kQd | kPosture | kXddCmd | kForces};
    default:  // those of contacts and objects are traced apart
      break;
  }
  return {};
}

}  // namespace treeline
