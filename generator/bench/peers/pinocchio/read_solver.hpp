#pragma once

#include <optional>

#include "bench/peers/pinocchio/description.hpp"
#include "bench/peers/pinocchio/solver.hpp"

namespace treeline::peer::pin {

std::optional<Solver<double>> read_solver(const Description& description);

}  // namespace treeline::peer::pin
