#pragma once

#include <cstdint>
#include <vector>

#include "description/scene.hpp"
#include "oracle/draw_state.hpp"
#include "program/evaluate.hpp"

namespace treeline {

/// A program, ready to be evaluated at many states as emitted code computes it, to the bit. It must
/// outlive this.
class GraphRun {
 public:
  explicit GraphRun(const Program& program);

  /// All results in `real`, one after another.
  [[nodiscard]] std::vector<double> results(const State& state, Real real) const;
  /// The magnitudes, added up, of the angles whose sine or cosine is taken and that are no inputs.
  [[nodiscard]] double computed_angles(const State& state) const;

 private:
  template <class T>
  [[nodiscard]] std::vector<T> node_values(const State& state) const;
  template <class T>
  [[nodiscard]] std::vector<double> results_in(const State& state) const;

  const Program* program_;
  std::vector<InputPlace> places_;
  std::vector<std::uint32_t> angles_;  ///< nodes, each once
};

/// A function's arguments at a state, in the order of its program.
std::vector<const std::vector<double>*> arguments_of(const Program& program, const State& state);

}  // namespace treeline
