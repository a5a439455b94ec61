#pragma once

#include "bench/peers/pinocchio/record.hpp"

namespace treeline::peer::pin {

/// Records M, both triangles, in our order of joints.
std::string record_whole_mass_matrix(const Solver<double>& solver);

}  // namespace treeline::peer::pin
