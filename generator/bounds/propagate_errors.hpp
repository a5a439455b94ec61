#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "program/program.hpp"

namespace treeline::bounds {

/// So many states are propagated together.
inline constexpr std::size_t kStatesAtOnce = 8;
using States = std::array<double, kStatesAtOnce>;

/// Rounding errors at given states, to first order: with g_k the derivative of a value by node k
/// and e_k the rounding there, its error is sum g_k e_k, at most sum |g_k| |e_k| whatever the
/// compiler contracts or not (Linnainmaa 1976; Higham, Accuracy and Stability, section 26.1). What
/// is left out is smaller by the rounding unit times the condition.
class ErrorPropagation {
 public:
  /// `graph` must outlive this. `unit` is 2^-53 for double, 2^-24 for float, in which constants
  /// are rounded too.
  ErrorPropagation(const Graph& graph, double unit);

  /// Values of all nodes; `inputs` are those of the graph, in its order.
  void evaluate(const std::vector<States>& inputs);
  [[nodiscard]] const States& value(std::uint32_t node) const { return values_[node]; }

  /// The most that the node's error can be at the states that were evaluated, in rounding units.
  const States& bound(std::uint32_t node);

  /// Draws a sign for each rounding; `sampled` are the errors that come of it, in rounding units.
  void sample(std::uint64_t seed);
  [[nodiscard]] const States& sampled(std::uint32_t node) const { return samples_[node]; }

 private:
  const Graph& graph_;
  double underflow_;          ///< the smallest number above zero, in rounding units
  std::vector<bool> rounds_;  ///< whether there is a rounding at the node at all
  std::vector<States> values_, derivatives_, samples_;
  States bound_{};
};

}  // namespace treeline::bounds
