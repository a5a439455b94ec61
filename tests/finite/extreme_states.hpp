#pragma once

#include <cstdint>
#include <vector>

#include "bounds/dice.hpp"
#include "oracle/draw_state.hpp"

/// Inputs at which code that divides, or that squares too often, would stop being finite.
namespace treeline::tests {

/// How large inputs get, SI units. Squares of speeds, and forces times squares of lengths, stay far
/// within what the number type holds.
struct InputSizes {
  double angle, quaternion, velocity, acceleration;
};
constexpr InputSizes input_sizes(Real real) {
  return real == Real::float32 ? InputSizes{1e8, 1e9, 1e9, 1e18}
                               : InputSizes{1e300, 1e150, 1e100, 1e200};
}

/// Draws states whose coordinates are, each time in another mixture: 0, at their limits, folded
/// (every joint at one end), at quarter turns, of many turns, next to nothing, denormal, ordinary,
/// or where a task is singular, exactly or a few roundings beside; quaternions of every length, 0
/// too; rates and forces of 0, ordinary, next to nothing and as large as `input_sizes` permits.
class ExtremeStates {
 public:
  /// `space` must outlive this. `length`: the largest displacement, m. `singular`: poses to come
  /// back to, see `find_singular_poses`.
  ExtremeStates(const StateSpace& space, double length, std::vector<std::vector<double>> singular);

  /// A matter of the space's seed and the index alone.
  [[nodiscard]] State draw(std::int64_t index) const;

 private:
  [[nodiscard]] double draw_coordinate(Dice& dice, int kind, std::size_t i) const;
  [[nodiscard]] std::vector<double> draw_pose(Dice& dice) const;
  void draw_quaternion(Dice& dice, double* xyzw) const;
  [[nodiscard]] std::vector<double> draw_rates(Dice& dice, std::size_t count, double most) const;
  [[nodiscard]] static std::vector<double> draw_directions(Dice& dice, std::size_t count);
  void round(State& state) const;

  const StateSpace& space_;
  std::vector<std::vector<double>> singular_;
  std::vector<int> quaternions_;  ///< first entries of quaternions in q
  InputSizes sizes_;
  double length_;
};

/// Poses at which Lambda^-1 of the space's points has next to no smallest eigenvalue, found by
/// going down along one coordinate after the other within the limits, from `count` starts.
std::vector<std::vector<double>> find_singular_poses(const StateSpace& space, int count);

}  // namespace treeline::tests
