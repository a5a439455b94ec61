#pragma once

#include "program/program.hpp"

namespace treeline {

/// The program with sines and cosines of joint angles as inputs `sin_q[i]` and `cos_q[i]`, which
/// its arguments then list behind `q`; those of sums of angles and constants follow by the theorem
/// of addition. For scenes with `sin_cos: given`: a controller that calls several functions in one
/// state, or has encoders that deliver them, computes none twice. What a multiple of a joint's
/// angle needs (mimics with a factor) is still computed.
Program take_sines(const Program& program);

}  // namespace treeline
