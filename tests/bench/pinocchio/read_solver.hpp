#pragma once

#include <optional>

#include "pinocchio/description.hpp"
#include "pinocchio/solver.hpp"

namespace treeline::bench::pin {

std::optional<Solver<double>> read_solver(const Description& description);

}  // namespace treeline::bench::pin
