#pragma once

#include <string>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// Prints each base parameter of the robot in the scene with its combination of the links'
/// parameters and its value, and the parameters on which no motion depends.
std::string print_base_parameters(const Robot& robot, const Scene& scene);

/// Prints base parameters as JSON for programs, with full coefficients, values and units: in the
/// order of the argument `parameters` and of the columns of regressors.
std::string print_base_parameters_json(const Robot& robot, const Scene& scene);

}  // namespace treeline
