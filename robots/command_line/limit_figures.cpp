#include "command_line/limit_figures.hpp"

#include <fmt/core.h>

namespace treeline::experiments {

void LimitFigures::add(const LimitFigures& other) noexcept {
  base_torque = std::max(base_torque, other.base_torque);
  torque = std::max(torque, other.torque);
  beyond = std::max(beyond, other.beyond);
  slack = std::max(slack, other.slack);
  limited += other.limited;
  unsolved += other.unsolved;
  iterations = std::max(iterations, other.iterations);
}

bool LimitFigures::kept() const noexcept {
  constexpr double kRounding = 1e-8;  // of forces of some 1000 N
  return base_torque == 0.0 && torque <= 1.0 && beyond < kRounding && slack == 0.0 && unsolved == 0;
}

std::string describe_limits(const LimitFigures& figures) {
  return fmt::format(
      "torque                    at the base {} N m; of a motor {:.3f} of its limit, largest\n"
      "forces beyond a cone      {:.1e} N, largest; cones widened by {:.1e} N\n"
      "limits reached            in {} cycles, {} not solved, at most {} iterations\n",
      figures.base_torque, figures.torque, figures.beyond, figures.slack, figures.limited,
      figures.unsolved, figures.iterations);
}

}  // namespace treeline::experiments
