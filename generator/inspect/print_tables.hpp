#pragma once

#include <string>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "inspect/report.hpp"

namespace treeline {

/// Prints each base parameter of the robot in the scene with its combination of the links'
/// parameters and its value, and the parameters on which no motion depends.
std::string print_base_parameters(const Robot& robot, const Scene& scene);

/// Prints base parameters as JSON for programs, with full coefficients, values and units: in the
/// order of the argument `parameters` and of the columns of regressors.
std::string print_base_parameters_json(const Robot& robot, const Scene& scene);

/// Prints for people which inertias are impossible, whether they affect the motion, and which
/// bodies are flat. Empty if there is nothing to report.
std::string print_inertias(const Report& report);

/// Prints a line for each number of the files, and for each relation between frames, that is taken
/// as exact, with its place and the difference; also what `noise:` could change beyond that.
std::string print_noise(const Robot& robot, const Scene& scene);

}  // namespace treeline
