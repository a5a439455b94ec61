#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "program/program.hpp"

namespace treeline::bounds {

/// Number of states that are propagated together.
inline constexpr std::size_t kStatesAtOnce = 8;
using States = std::array<double, kStatesAtOnce>;

/// Rounding errors at given states, to first order. With g_k the derivative of a value with respect
/// to node k and e_k the rounding error there, the error of the value is sum g_k e_k. This is at
/// most sum |g_k| |e_k|, whatever the compiler contracts (Linnainmaa 1976; Higham, Accuracy and
/// Stability, section 26.1). The neglected terms are smaller by the rounding unit times the
/// condition number.
class ErrorPropagation {
 public:
  /// `graph` must outlive this object. `unit` is 2^-53 for double and 2^-24 for float, for which
  /// constants are rounded too.
  ErrorPropagation(const Graph& graph, double unit);

  /// Computes the values of all nodes. `inputs` has one entry for each input of the graph, in its
  /// order.
  void evaluate(const std::vector<States>& inputs);
  [[nodiscard]] const States& value(std::uint32_t node) const { return values_[node]; }

  /// Upper bound of the node's error at the states that were evaluated last, in rounding units.
  const States& bound(std::uint32_t node);

  /// Draws a random sign for each rounding. `sampled` then returns the resulting errors in rounding
  /// units.
  void sample(std::uint64_t seed);
  [[nodiscard]] const States& sampled(std::uint32_t node) const { return samples_[node]; }

 private:
  /// Flow into the derivative of an operand: its users add to it, from the last to the first, and
  /// the last sets it. Inputs and exact constants need no derivative.
  enum class Flow : std::uint8_t { none, set, add };
  struct Visit {
    std::uint32_t node = 0;
    Flow a = Flow::none, b = Flow::none;
  };

  void find_cone(std::uint32_t node);
  void visit_backwards(const Visit& visit);

  const Graph& graph_;
  double underflow_;          ///< smallest positive number, in rounding units
  std::vector<bool> rounds_;  ///< by node, whether its operation rounds
  std::vector<States> values_, derivatives_, samples_;
  std::vector<Visit> cone_;  ///< of the node that was bounded last
  States bound_{};
};

}  // namespace treeline::bounds
