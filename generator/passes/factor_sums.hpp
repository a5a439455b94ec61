#pragma once

#include "program/program.hpp"

namespace treeline {

/// Takes common factors out of sums: a c + b c -> (a + b) c, one product less for each term but the
/// first. Sums are looked at whole, across the nodes that make them up, as far as these and the
/// products in them have no other use, so that nothing is computed twice for it. The
/// factor that most terms share goes first.
Program factor_sums(const Program& program);

}  // namespace treeline
