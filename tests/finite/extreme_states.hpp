#pragma once

#include <cstdint>
#include <vector>

#include "bounds/rng.hpp"
#include "oracle/draw_state.hpp"

/// Inputs for which code that divides, or squares too often, would stop being finite.
namespace treeline::tests {

/// Largest magnitudes of inputs, SI units. Squares of velocities, and forces times squares of
/// lengths, stay far within the range of the number type.
struct InputSizes {
  double angle, quaternion, velocity, acceleration;
};
constexpr InputSizes input_sizes(Real real) {
  return real == Real::float32 ? InputSizes{1e8, 1e9, 1e9, 1e18}
                               : InputSizes{1e300, 1e150, 1e100, 1e200};
}

/// Draws states whose coordinates are a new mixture each time: 0, at their limits, folded (every
/// joint at one end), at quarter turns, of many turns, tiny, denormal, ordinary, or exactly at or a
/// few roundings from a singularity of the task; quaternions of any length including 0; rates and
/// forces that are 0, ordinary, tiny, or as large as `input_sizes` permits.
class ExtremeStates {
 public:
  /// `space` must outlive this object. `length` is the largest displacement, m. `singular` are
  /// poses that recur, see `find_singular_poses`.
  ExtremeStates(const StateSpace& space, double length, std::vector<std::vector<double>> singular);

  /// Draws a state. It depends only on the space's seed and the index.
  [[nodiscard]] State draw(std::int64_t index) const;

 private:
  [[nodiscard]] double draw_coordinate(Rng& rng, int kind, std::size_t i) const;
  [[nodiscard]] std::vector<double> draw_pose(Rng& rng) const;
  void draw_quaternion(Rng& rng, double* xyzw) const;
  [[nodiscard]] std::vector<double> draw_rates(Rng& rng, std::size_t count, double most) const;
  [[nodiscard]] static std::vector<double> draw_directions(Rng& rng, std::size_t count);
  void round(State& state) const;

  const StateSpace& space_;
  std::vector<std::vector<double>> singular_;
  std::vector<int> quaternions_;  ///< first entries of quaternions in q
  InputSizes sizes_;
  double length_;
};

/// Finds poses at which Lambda^-1 of the space's points has a smallest eigenvalue near zero, by
/// descending along one coordinate after the other within the limits, from `count` starts.
std::vector<std::vector<double>> find_singular_poses(const StateSpace& space, int count);

}  // namespace treeline::tests
