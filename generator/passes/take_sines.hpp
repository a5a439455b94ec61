#pragma once

#include "program/program.hpp"

namespace treeline {

/// Replaces sines and cosines of joint angles by inputs `sin_q[i]` and `cos_q[i]`, which follow `q`
/// in the list of arguments. Those of sums of angles and constants follow from the addition
/// theorems. This serves scenes with `sin_cos: given`: a controller that calls several functions in
/// one state, or whose encoders deliver sines and cosines, computes none twice. Sines and cosines
/// of multiples of an angle (mimic joints with a factor) are still computed.
Program take_sines(const Program& program);

/// Adds sin_q and cos_q to the arguments where the program reads them.
void declare_sines(Program& program);

}  // namespace treeline
