#pragma once
// Limits of motors and supports, and what became of them, see limited_torque.hpp.

#include "core/quadratic_rows.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// In place of a limit that there is not.
template <class Real>
inline constexpr Real kNoLimit = Real(1e30);

/// A row of a cone: coefficients of up to six forces of a support, from `first` on, whose sum is at
/// most `bound`.
template <class Real>
struct ConeRow {
  int first, count;
  Real coefficients[6];
  Real bound;
};

/// Columns of matrices are padded to a multiple of eight, which compilers turn into SIMD.
constexpr int in_eights(int count) noexcept {
  return (count + 7) / 8 * 8;
}

/// Sizes of a robot's program: velocities, passive ones, held rows, task rows, rows of cones, and
/// freedoms: nv less the rank of the held rows, plus the held rows less the rank of their passive
/// columns.
template <int V, int P, int H, int T, int C, int F>
struct LimitSizes {
  static constexpr int kVelocities = V, kPassive = P, kHeld = H, kTask = T, kCones = C;
  static constexpr int kFreedoms = F;
  static constexpr int kSlackAt = F;  ///< among the unknowns
  static constexpr int kUnknowns = in_eights(F + 1);
  static constexpr int kMotors = V - P;
  static constexpr int kRows = V - P + C;  ///< motors, cones
};

/// Arrays have at least one entry.
constexpr int one_or(int count) noexcept {
  return count > 0 ? count : 1;
}

/// What may be asked of motors and supports.
template <class Real, class Sizes>
struct TorqueLimits {
  Real torque[Sizes::kVelocities];  ///< largest magnitude; `kNoLimit`: none
  ConeRow<Real> cones[one_or(Sizes::kCones)];
  Real task_weights[one_or(Sizes::kTask)];  ///< of task rows against each other
};

/// What of the robot is constant.
template <class Real, class Sizes>
struct SupportLayout {
  int passive[one_or(Sizes::kPassive)];      ///< velocities without a motor
  Real force_weights[one_or(Sizes::kHeld)];  ///< roots: 1, or the lever of a moment, m
};

/// What became of the limits. Keep it from cycle to cycle: it has the start of the next one.
template <class Real, class Sizes>
struct LimitedTorque {
  bool limited;            ///< whether anything had to be changed
  QuadraticStatus status;  ///< `solved`, or `limit`: iterations used up, torques are only clipped
  Real slack;              ///< N by which cones were widened; 0 where forces are within them
  Real lost[one_or(
      Sizes::kTask)];  ///< xdd of the task rows by the unlimited law, less what is left of it
  int iterations;
  QuadraticSolution<Real, Sizes::kUnknowns, Sizes::kRows> program;
};

/// k of the cost.
template <class Real>
inline constexpr Real kHierarchy = Real(1000);
template <>
inline constexpr float kHierarchy<float> = 30.0F;

/// Of the slack's square, N^-2: above any multiplier that costs of the task give rise to.
template <class Real>
inline constexpr Real kSlackPenalty = Real(1e4) * kHierarchy<Real>* kHierarchy<Real>;

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
