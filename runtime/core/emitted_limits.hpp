#pragma once
// The headers of runtime/emitted for quadratic programs and limits of torque, as members of a class
// of any number type and any sizes. C++17, freestanding.

#include <stdint.h>

#include "core/in_eights.hpp"
#include "core/sin_cos.hpp"
#include "core/square_root.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// Arrays have at least one entry.
constexpr int one_or(int count) noexcept {
  return count > 0 ? count : 1;
}

/// The default bound on iterations of a program of n unknowns and m rows.
constexpr int most_iterations(int n, int m) noexcept {
  return 4 * (n + m);
}

/// The most operations in one iteration: slacks of all rows, |A| |x| of those that are missed, J^T
/// n, a step, the rotations that drop a row, which take more than the reflection that adds one, and
/// x from the factors.
constexpr long flops_of_iteration(int n, int m) noexcept {
  return 4L * m * n + 20L * n * n + 16L * (n + m);
}

/// Outcome of a quadratic program.
enum class QuadraticStatus {
  solved,       ///< all rows hold
  conflicting,  ///< rows that conflict with others were set aside, see `sides`
  limit,        ///< the iterations were used up: x is the minimum over the active rows alone
  not_convex,   ///< H is not positive definite, or numbers do not fit or are none: x is zero
};

/// Active side of a row.
enum class RowSide : signed char { lower = -1, none = 0, upper = 1, set_aside = 2 };

/// Tolerances and weights of the method.
template <class Real>
struct LimitNumbers {
  static constexpr bool kSingle = Format<Real>::kFractionBits < 24;
  /// A row holds within so many units of rounding of its terms.
  static constexpr Real kRowTolerance = Real(512) * Format<Real>::kEpsilon;
  /// And so much of the terms that its value had at the centre, from which steps come: 4 units.
  static constexpr Real kCenterShare = Real(1) / Real(128);
  /// And so many once it has left and come back; in float, whose terms cancel more, no more.
  static constexpr Real kLoosestTolerance =
      Real(kSingle ? 1 << 9 : 1 << 22) * Format<Real>::kEpsilon;
  /// A row depends on others where so little of its normal is left.
  static constexpr Real kDependent = Real(256) * Format<Real>::kEpsilon;
  /// A cone of which less is left, by its share to the seventh, is left out. It all but depends on
  /// the bound of the slack; in float the cones of larger shares count in spite of that.
  static constexpr Real kLeastCone = Real(kSingle ? 1 : 256) * kDependent;
  /// A row that depends on others contradicts them where it misses by so much of its terms.
  static constexpr Real kContradiction = Real(1 << 15) * Format<Real>::kEpsilon;
  /// A row of constraints that has less than this share left outside the rows before it depends on
  /// them.
  static constexpr Real kRankTolerance =
      kSingle ? Real(1e-3) : Real(4.6e6) * Format<Real>::kEpsilon;
  /// In place of a limit that there is not.
  static constexpr Real kNoLimit = Real(1e30);
  /// k of the cost.
  static constexpr Real kHierarchy = Real(kSingle ? 30 : 1000);
  /// Weight N^-2 of the slack's square: above any multiplier from the costs of the task.
  static constexpr Real kSlackPenalty = Real(1e4) * kHierarchy * kHierarchy;
};

/// Sizes of a robot's program: velocities, passive ones, held rows, task rows, rows of cones, and
/// freedoms: nv less the rank of the held rows, plus the held rows less the rank of their passive
/// columns.
template <int V, int P, int H, int T, int C, int F>
struct LimitSizes {
  static constexpr int kVelocities = V, kPassive = P, kHeld = H, kTask = T, kCones = C;
  static constexpr int kFreedoms = F;
  static constexpr int kUnknowns = in_eights(F + 1);
  static constexpr int kRows = V - P + C;  ///< motors, cones
};

/// Sizes of a quadratic program alone.
template <int N, int M>
struct ProgramSizes : LimitSizes<1, 0, 0, 0, 0, 1> {
  static constexpr int kUnknowns = in_eights(N), kRows = M;
};

#define TL_INLINE static inline
#define TL_FUNCTION static
#define TL_SHARES 1

/// Everything of runtime/emitted/limited_torque.h.
template <class Number, class Sizes, int states = 1>
struct EmittedLimits {
  using real = Number;
  using Numbers = LimitNumbers<real>;
  static constexpr int32_t TL_REAL_BYTES = sizeof(real);
  static constexpr real TL_ZERO = 0, TL_ONE = 1, TL_TEN = 10;
  static constexpr int32_t TL_VELOCITIES = Sizes::kVelocities, TL_PASSIVE = Sizes::kPassive,
                           TL_MOTORS = TL_VELOCITIES - TL_PASSIVE, TL_HELD_ROWS = Sizes::kHeld,
                           TL_TASK_ROWS = Sizes::kTask, TL_CONES = Sizes::kCones,
                           TL_FREEDOMS = Sizes::kFreedoms, TL_UNKNOWNS = Sizes::kUnknowns,
                           TL_LIMIT_ROWS = Sizes::kRows, TL_ALL_ROWS = TL_UNKNOWNS + TL_LIMIT_ROWS,
                           TL_PASSIVE_ENTRIES = one_or(TL_PASSIVE),
                           TL_HELD_ENTRIES = one_or(TL_HELD_ROWS),
                           TL_TASK_ENTRIES = one_or(TL_TASK_ROWS),
                           TL_CONE_ENTRIES = one_or(TL_CONES),
                           TL_BASIS_COLS = in_eights(TL_PASSIVE_ENTRIES + TL_HELD_ENTRIES),
                           TL_TASK_AT = TL_PASSIVE_ENTRIES + TL_HELD_ENTRIES,
                           TL_MASS_AT = TL_TASK_AT + TL_TASK_ENTRIES,
                           TL_MASS_END = in_eights(TL_MASS_AT + TL_VELOCITIES),
                           TL_FORCES_AT = TL_MASS_END,
                           TL_COLS = TL_MASS_END + in_eights(TL_HELD_ENTRIES),
                           TL_TABLE_ROWS = TL_VELOCITIES + TL_HELD_ENTRIES,
                           TL_TABLE_ENTRIES = TL_TABLE_ROWS * TL_COLS,
                           TL_TASK_COLS = TL_COLS - TL_TASK_AT,
                           TL_FORCE_ENTRIES = TL_HELD_ENTRIES * TL_UNKNOWNS,
                           TL_CARRIED_ENTRIES = TL_PASSIVE_ENTRIES * TL_UNKNOWNS,
                           TL_MOST_ROWS = TL_TABLE_ROWS,
                           TL_MOST_ITERATIONS = most_iterations(TL_UNKNOWNS, TL_LIMIT_ROWS),
                           TL_STATES = states;
  static constexpr auto TL_SOLVED = static_cast<int32_t>(QuadraticStatus::solved),
                        TL_CONFLICTING = static_cast<int32_t>(QuadraticStatus::conflicting),
                        TL_LIMIT = static_cast<int32_t>(QuadraticStatus::limit),
                        TL_NOT_CONVEX = static_cast<int32_t>(QuadraticStatus::not_convex);
  static constexpr auto TL_LOWER = static_cast<int32_t>(RowSide::lower),
                        TL_FREE = static_cast<int32_t>(RowSide::none),
                        TL_UPPER = static_cast<int32_t>(RowSide::upper),
                        TL_SET_ASIDE = static_cast<int32_t>(RowSide::set_aside);
  static constexpr real TL_DEPENDENT = Numbers::kDependent,
                        TL_ROW_TOLERANCE = Numbers::kRowTolerance,
                        TL_LOOSEST_TOLERANCE = Numbers::kLoosestTolerance,
                        TL_LEAST_CONE = Numbers::kLeastCone,
                        TL_CENTER_SHARE = Numbers::kCenterShare,
                        TL_CONTRADICTION = Numbers::kContradiction,
                        TL_RANK_TOLERANCE = Numbers::kRankTolerance,
                        TL_HIERARCHY = Numbers::kHierarchy, TL_NO_LIMIT = Numbers::kNoLimit,
                        TL_SLACK_PENALTY = Numbers::kSlackPenalty;

  static real tl_root(real x) { return square_root(x > TL_ZERO ? x : TL_ZERO); }

#include "emitted/limited_states.h"
};

#undef TL_INLINE
#undef TL_FUNCTION
#undef TL_SHARES

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
