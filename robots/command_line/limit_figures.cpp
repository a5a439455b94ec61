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

std::string rows_of_limits(const LimitFigures& figures) {
  return fmt::format(
      "| forces chosen, beyond a cone | below 1e{:.0f} N, {} |\n"
      "| cycles at a limit | about {}, at most {} iterations, {} |\n",
      std::floor(std::log10(std::max(figures.beyond, 1e-300))) + 1,
      figures.slack == 0.0 ? "no cone widened" : fmt::format("by {:.1e} N", figures.slack),
      (figures.limited + 50) / 100 * 100, figures.iterations,
      figures.unsolved == 0 ? "all solved" : fmt::format("{} not solved", figures.unsolved));
}

}  // namespace treeline::experiments
