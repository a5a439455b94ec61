#pragma once

#include <cstdint>
#include <vector>

#include "description/scene.hpp"
#include "oracle/draw_state.hpp"
#include "program/evaluate.hpp"

namespace treeline {

/// Evaluates a program at many states exactly as emitted code computes it, to the bit. The program
/// must outlive this object.
class GraphRun {
 public:
  explicit GraphRun(const Program& program);

  /// All results, computed in `real`, one after another.
  [[nodiscard]] std::vector<double> results(const State& state, Real real) const;
  /// Sum of the magnitudes of all angles that are not inputs and whose sine or cosine is taken.
  [[nodiscard]] double computed_angles(const State& state) const;

 private:
  template <class T>
  [[nodiscard]] std::vector<T> node_values(const State& state) const;
  template <class T>
  [[nodiscard]] std::vector<double> results_in(const State& state) const;

  const Program* program_;
  std::vector<InputPlace> places_;
  std::vector<std::uint32_t> angles_;  ///< distinct nodes
};

/// Arguments of a program's function at a state, in the order of the program.
std::vector<const std::vector<double>*> arguments_of(const Program& program, const State& state);

}  // namespace treeline
