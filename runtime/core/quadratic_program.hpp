#pragma once
// Strictly convex quadratic programs of fixed size: minimise 1/2 x^T H x + g^T x with lowest <= x
// <= highest and lower <= A x <= upper. C++17, freestanding, no heap, a stated bound on the work.
//
// The dual active-set method of Goldfarb & Idnani (Math. Programming 27, 1983). It starts at the
// minimum without rows and makes one violated row active after the other; rows whose multiplier
// would change its sign leave. With H = L L^T and the active rows' normals n_j as columns of B,
//
//     J = L^-T Q,   J^T B = (R; 0),   R upper triangular,
//
// where Q is orthogonal: Householder reflections add a row, Givens rotations take one out. So
// dependent and nearly dependent rows are told apart by |J_2^T n| against |J^T n|, which has no
// unit. Any active set whose multipliers have the right sign is a start: the one of the last cycle
// saves what it has in common with this one's.
//
// Work: at most `most_iterations` steps, 4 (N + M) unless told otherwise, of which each adds or
// drops a row, and at most as many again and N that drop a row when x is found anew from the
// factors. Each takes at most `flops_of_iteration(N, M)` operations; what comes before, the factor
// of H and the rows of a warm start, takes at most 8 N^3. (Arnstrom, Bemporad & Axehill 2022
// certify tighter bounds of one parametric program offline.)
//
// Conflicts: when a violated row depends on active rows that cannot leave, no x obeys all of them,
// and the violation is the least that the active rows permit. That row is set aside and the rest is
// solved. So x is always the minimum over rows that do not conflict.

#include "core/sin_cos.hpp"
#include "core/square_root.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

enum class QuadraticStatus {
  solved,       ///< all rows hold
  conflicting,  ///< rows that conflict with others were set aside, see `sides`
  limit,        ///< the iterations were used up: x is the minimum over the active rows alone
  not_convex,   ///< H is not positive definite, or numbers do not fit: x is zero
};

/// Which side of a row is active.
enum class RowSide : signed char { lower = -1, none = 0, upper = 1, set_aside = 2 };

/// Rows lowest <= x <= highest and lower <= A x <= upper, A row-major. Infinite where there is no
/// limit; equal for an equation. Row i < N is a bound of x[i], row N + i is row i of A.
template <class Real, int N, int M>
struct QuadraticRows {
  Real lowest[N], highest[N];
  Real A[M * N];
  Real lower[M], upper[M];
};

/// H x + g = sum of multipliers[i] times row i: positive at the lower side, negative at the upper.
template <class Real, int N, int M>
struct QuadraticSolution {
  Real x[N];
  Real multipliers[N + M];
  RowSide
      sides[N + M];  ///< on entry, if `warm`: the rows to start with, those of the last solution
  bool warm;         ///< on entry: whether `sides` holds a start; true on return
  QuadraticStatus status;
  int conflicting_row;  ///< the first that was set aside, or -1
  int iterations;
};

/// The default bound on iterations.
constexpr int most_iterations(int n, int m) noexcept {
  return 4 * (n + m);
}

/// The most operations in one iteration: slacks of all rows, |A| |x| of those that are missed, J^T
/// n, a step, the rotations that drop a row, which take more than the reflection that adds one, and
/// x from the factors.
constexpr long flops_of_iteration(int n, int m) noexcept {
  return 4L * m * n + 20L * n * n + 16L * (n + m);
}

namespace steps {

template <class Real>
constexpr Real size_of(Real x) noexcept {
  return x < Real(0) ? -x : x;
}
template <class Real>
constexpr Real larger_of(Real a, Real b) noexcept {
  return a < b ? b : a;
}
/// False for NaN and infinities.
template <class Real>
constexpr bool is_finite(Real x) noexcept {
  return x - x == Real(0);
}

/// Sum of products, in eight sums that run side by side.
template <int N, class Real>
inline Real dot_of(const Real* a, const Real* b) noexcept {
  Real sums[8];
  for (Real& each : sums) each = Real(0);
  int i = 0;
  for (; i + 8 <= N; i += 8) {
    for (int k = 0; k < 8; ++k) sums[k] += a[i + k] * b[i + k];
  }
  for (int k = 0; i + k < N; ++k) sums[k] += a[i + k] * b[i + k];
  return ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

/// The same of their sizes.
template <int N, class Real>
inline Real dot_of_sizes(const Real* a, const Real* b) noexcept {
  Real sums[8];
  for (Real& each : sums) each = Real(0);
  int i = 0;
  for (; i + 8 <= N; i += 8) {
    for (int k = 0; k < 8; ++k) sums[k] += size_of(a[i + k] * b[i + k]);
  }
  for (int k = 0; i + k < N; ++k) sums[k] += size_of(a[i + k] * b[i + k]);
  return ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

/// x + sum of factors[k] times row k of `rows`, k from `first` to before `last`.
template <int N, class Real>
inline void add_rows(const Real* factors, const Real* rows, int first, int last,
                     Real (&x)[N]) noexcept {
  Real sum[N];
  for (int i = 0; i < N; ++i) sum[i] = x[i];
  for (int k = first; k < last; ++k) {
    const Real factor = factors[k];
    for (int i = 0; i < N; ++i) sum[i] += factor * rows[k * N + i];
  }
  for (int i = 0; i < N; ++i) x[i] = sum[i];
}

/// Of numbers that are compared: a row holds within so many units of rounding of its terms.
template <class Real>
inline constexpr Real kRowTolerance = Real(512) * Format<Real>::kEpsilon;
/// A row depends on others where so little of its normal is left.
template <class Real>
inline constexpr Real kDependent = Real(256) * Format<Real>::kEpsilon;
/// A row that depends on others contradicts them where it misses by so much of its terms.
template <class Real>
inline constexpr Real kContradiction = Real(1 << 15) * Format<Real>::kEpsilon;

/// The answer where there is none.
template <class Real, int N, int M>
void give_up(QuadraticSolution<Real, N, M>& solution) noexcept {
  for (int i = 0; i < N; ++i) solution.x[i] = Real(0);
  for (int row = 0; row < N + M; ++row) {
    solution.multipliers[row] = Real(0);
    solution.sides[row] = RowSide::none;
  }
  solution.status = QuadraticStatus::not_convex;
  solution.conflicting_row = -1;
}

/// The method's state. `Jt` has the columns of J as rows.
template <class Real, int N, int M>
class DualActiveSet {
 public:
  static constexpr int kRows = N + M;

  DualActiveSet(const QuadraticRows<Real, N, M>& rows, QuadraticSolution<Real, N, M>& solution,
                int most) noexcept
      : rows_(rows), solution_(solution), left_(most) {
    for (int i = 0; i < M; ++i) {
      const Real* const a = rows.A + i * N;
      const Real square = dot_of<N>(a, a);
      inverse_squares_[i] = square > Real(0) ? Real(1) / square : Real(0);
    }
    for (bool& each : ignored_) each = false;
  }

  /// J = L^-T and the minimum without rows. False where H is not positive definite.
  bool start(const Real (&H)[N * N], const Real (&g)[N]) noexcept;
  /// J = 1 and the minimum without rows `center`: H = 1.
  void start_at(const Real (&center)[N]) noexcept;
  void solve() noexcept;

 private:
  struct Violation {
    int row = -1;
    RowSide side = RowSide::none;
    Real amount = 0;     ///< by which the row is missed
    Real tolerance = 0;  ///< of a contradiction
  };

  void begin() noexcept;
  void add_start() noexcept;
  [[nodiscard]] Violation most_violated() const noexcept;
  template <class Terms>
  void consider(int row, Real value, Real inverse_square, const Terms& terms_of, Violation& worst,
                Real& worst_square) const noexcept;
  void project_normal(int row, RowSide side) noexcept;
  [[nodiscard]] Real free_part() const noexcept;
  [[nodiscard]] bool depends(Real free) const noexcept;
  void enter(const Violation& violation) noexcept;
  bool take_step(const Violation& violation, Real& missing, Real& multiplier) noexcept;
  [[nodiscard]] int first_to_leave(Real& step) const noexcept;
  void solve_for_r() noexcept;
  void add(int row, RowSide side, Real free, Real multiplier) noexcept;
  void drop(int index) noexcept;
  void settle() noexcept;
  void correct() noexcept;
  void find_multipliers() noexcept;
  void set_aside(const Violation& violation) noexcept;
  void finish() noexcept;
  /// Of active rows; compilers do not see that there are never more than N.
  [[nodiscard]] int count() const noexcept { return count_ < N ? count_ : N; }
  [[nodiscard]] bool may_leave(int index) const noexcept { return !is_equation(active_[index]); }
  [[nodiscard]] Real lower(int row) const noexcept {
    return row < N ? rows_.lowest[row] : rows_.lower[row - N];
  }
  [[nodiscard]] Real upper(int row) const noexcept {
    return row < N ? rows_.highest[row] : rows_.upper[row - N];
  }
  [[nodiscard]] bool is_equation(int row) const noexcept { return lower(row) == upper(row); }
  /// +1 where the row's normal is its row of A, -1 where it is the opposite.
  [[nodiscard]] static Real sign(RowSide side) noexcept {
    return side == RowSide::upper ? Real(-1) : Real(1);
  }

  const QuadraticRows<Real, N, M>& rows_;
  QuadraticSolution<Real, N, M>& solution_;
  int left_ = 0;         ///< iterations
  int count_ = 0;        ///< of active rows
  bool ignored_[kRows];  ///< depends on active rows, holds but for rounding
  Real inverse_squares_[M];
  Real x0_[N];  ///< the minimum without rows
  Real Jt_[N * N];
  Real R_[N * N];
  int active_[N];
  Real u_[N], d_[N], r_[N];
};

template <class Real, int N, int M>
bool DualActiveSet<Real, N, M>::start(const Real (&H)[N * N], const Real (&g)[N]) noexcept {
  Real L[N * N];
  for (int j = 0; j < N; ++j) {
    for (int i = j; i < N; ++i) {
      Real entry = H[i * N + j];
      for (int k = 0; k < j; ++k) entry -= L[i * N + k] * L[j * N + k];
      if (i == j) {
        if (!(entry > Format<Real>::kEpsilon * H[j * N + j]) || !is_finite(entry)) return false;
        L[j * N + j] = square_root(entry);
      } else {
        L[i * N + j] = entry / L[j * N + j];
      }
    }
  }
  // Row k of Jt is L^-1 e_k: zero before entry k.
  for (int i = 0; i < N * N; ++i) Jt_[i] = Real(0);
  for (int i = 0; i < N; ++i) {
    for (int k = 0; k <= i; ++k) {
      Real entry = i == k ? Real(1) : Real(0);
      for (int j = k; j < i; ++j) entry -= L[i * N + j] * Jt_[j * N + k];
      Jt_[i * N + k] = entry / L[i * N + i];
    }
  }
  for (int i = 0; i < N; ++i) x0_[i] = Real(0);
  for (int k = 0; k < N; ++k) {
    const Real along = dot_of<N>(Jt_ + k * N, g);
    for (int i = 0; i < N; ++i) x0_[i] -= along * Jt_[k * N + i];
  }
  begin();
  return true;
}

template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::start_at(const Real (&center)[N]) noexcept {
  for (int i = 0; i < N * N; ++i) Jt_[i] = Real(0);
  for (int i = 0; i < N; ++i) {
    Jt_[i * N + i] = Real(1);
    x0_[i] = center[i];
  }
  begin();
}

template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::begin() noexcept {
  for (int i = 0; i < N; ++i) solution_.x[i] = x0_[i];
  solution_.status = QuadraticStatus::solved;
  solution_.conflicting_row = -1;
  solution_.iterations = 0;
}

/// Makes the rows of the start active that depend on no others, and drops those of the wrong sign.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::add_start() noexcept {
  RowSide first[kRows];
  for (int row = 0; row < kRows; ++row) {
    const bool starts = solution_.warm && solution_.sides[row] != RowSide::set_aside;
    first[row] = is_equation(row) ? RowSide::lower : starts ? solution_.sides[row] : RowSide::none;
    solution_.sides[row] = RowSide::none;
  }
  for (int pass = 0; pass < 2; ++pass) {
    const bool equations = pass == 0;
    for (int row = 0; row < kRows && count_ < N; ++row) {
      const Real bound = first[row] == RowSide::upper ? upper(row) : lower(row);
      if (first[row] == RowSide::none || is_equation(row) != equations || !is_finite(bound)) {
        continue;
      }
      project_normal(row, first[row]);
      const Real free = free_part();
      if (!depends(free)) add(row, first[row], free, Real(0));
    }
  }
  if (count_ > 0) settle();
}

/// Keeps the row if it is missed by more than those before, measured along its normal.
/// `terms_of()` is the sum of the sizes of its terms.
template <class Real, int N, int M>
template <class Terms>
void DualActiveSet<Real, N, M>::consider(int row, Real value, Real inverse_square,
                                         const Terms& terms_of, Violation& worst,
                                         Real& worst_square) const noexcept {
  const Real below = lower(row) - value;
  const Real above = value - upper(row);
  const bool is_below = below > above;
  const Real amount = is_below ? below : above;
  if (!(amount > Real(0)) || ignored_[row]) return;
  const Real square = amount * amount * inverse_square;
  if (!(square > worst_square)) return;
  const Real terms = terms_of() + size_of(is_below ? lower(row) : upper(row));
  if (!(amount > kRowTolerance<Real> * terms)) return;
  worst_square = square;
  worst = {row, is_below ? RowSide::lower : RowSide::upper, amount, kContradiction<Real> * terms};
}

template <class Real, int N, int M>
typename DualActiveSet<Real, N, M>::Violation DualActiveSet<Real, N, M>::most_violated()
    const noexcept {
  Violation worst;
  Real worst_square = Real(0);
  const Real(&x)[N] = solution_.x;
  for (int i = 0; i < N; ++i) {
    if (solution_.sides[i] != RowSide::none) continue;
    consider(
        i, x[i], Real(1), [&]() noexcept { return size_of(x[i]); }, worst, worst_square);
  }
  for (int i = 0; i < M; ++i) {
    if (solution_.sides[N + i] != RowSide::none) continue;
    const Real* const a = rows_.A + i * N;
    consider(
        N + i, dot_of<N>(a, x), inverse_squares_[i],
        [&]() noexcept { return dot_of_sizes<N>(a, x); }, worst, worst_square);
  }
  return worst;
}

/// d = J^T n of the row's normal.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::project_normal(int row, RowSide side) noexcept {
  for (int k = 0; k < N; ++k) {
    const Real along = row < N ? Jt_[k * N + row] : dot_of<N>(Jt_ + k * N, rows_.A + (row - N) * N);
    d_[k] = sign(side) * along;
  }
}

/// |J_2^T n|: how far the normal is from those of active rows, in the metric of H^-1.
template <class Real, int N, int M>
Real DualActiveSet<Real, N, M>::free_part() const noexcept {
  Real square = Real(0);
  for (int k = count(); k < N; ++k) square += d_[k] * d_[k];
  return square_root(square);
}

template <class Real, int N, int M>
bool DualActiveSet<Real, N, M>::depends(Real free) const noexcept {
  if (count_ == N) return true;
  return !(free > kDependent<Real> * square_root(dot_of<N>(d_, d_)));
}

/// r = R^-1 d_1: how the multipliers of active rows change with that of the new one.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::solve_for_r() noexcept {
  for (int i = 0; i < count(); ++i) r_[i] = d_[i];
  for (int j = count() - 1; j >= 0; --j) {
    r_[j] /= R_[j * N + j];
    for (int i = 0; i < j; ++i) r_[i] -= R_[i * N + j] * r_[j];
  }
}

/// The active row whose multiplier vanishes first, and at which step; -1 where none does.
template <class Real, int N, int M>
int DualActiveSet<Real, N, M>::first_to_leave(Real& step) const noexcept {
  int first = -1;
  for (int j = 0; j < count(); ++j) {
    if (!may_leave(j) || !(r_[j] > Real(0))) continue;
    const Real own = u_[j] / r_[j];
    if (first >= 0 && !(own < step)) continue;
    first = j;
    step = own;
  }
  return first;
}

/// One step towards making the row active. False when it is active, or set aside.
template <class Real, int N, int M>
bool DualActiveSet<Real, N, M>::take_step(const Violation& violation, Real& missing,
                                          Real& multiplier) noexcept {
  const Real free = free_part();
  const bool dependent = depends(free);
  solve_for_r();
  Real step = Real(0);
  const int leaving = first_to_leave(step);
  if (dependent && leaving < 0) {
    if (violation.amount > violation.tolerance) {
      set_aside(violation);
    } else {
      ignored_[violation.row] = true;
      settle();
    }
    return false;
  }
  const Real full = dependent ? Real(0) : missing / (free * free);
  const bool partial = dependent || (leaving >= 0 && step < full);
  if (!partial) step = full;
  if (!dependent) {
    Real along[N];
    for (int k = 0; k < N; ++k) along[k] = step * d_[k];
    add_rows(along, Jt_, count(), N, solution_.x);
  }
  for (int j = 0; j < count(); ++j) u_[j] -= step * r_[j];
  multiplier += step;
  if (!partial) {
    add(violation.row, violation.side, free, multiplier);
    return false;
  }
  if (!dependent) missing -= step * free * free;
  drop(leaving);
  return true;
}

template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::enter(const Violation& violation) noexcept {
  project_normal(violation.row, violation.side);
  Real missing = violation.amount;
  Real multiplier = Real(0);
  do {
    if (left_ == 0) {
      settle();
      return;
    }
    --left_;
    ++solution_.iterations;
  } while (take_step(violation, missing, multiplier));
}

/// Reflects J_2 so that J_2^T n is along its first column.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::add(int row, RowSide side, Real free, Real multiplier) noexcept {
  const int at = count_ < N ? count_ : N - 1;
  const Real first = d_[at];
  const Real to = first > Real(0) ? -free : free;
  Real v[N];
  Real sum[N];
  for (int k = 0; k < N; ++k) {
    v[k] = d_[k];
    sum[k] = Real(0);
  }
  v[at] -= to;
  const Real scale = Real(1) / (free * (free + size_of(first)));
  add_rows(v, Jt_, at, N, sum);
  for (int k = at; k < N; ++k) {
    const Real along = scale * v[k];
    for (int i = 0; i < N; ++i) Jt_[k * N + i] -= along * sum[i];
  }
  for (int k = 0; k < at; ++k) R_[k * N + at] = d_[k];
  R_[at * N + at] = to;
  u_[at] = multiplier;
  active_[at] = row;
  solution_.sides[row] = side;
  ++count_;
}

/// Takes an active row out; rotates J, R and d.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::drop(int index) noexcept {
  solution_.sides[active_[index]] = RowSide::none;
  for (bool& each : ignored_) each = false;
  --count_;
  const int left = count_ < N - 1 ? count_ : N - 1;
  const int first = index < 0 ? 0 : index;
  for (int j = first; j < left; ++j) {
    active_[j] = active_[j + 1];
    u_[j] = u_[j + 1];
    for (int i = 0; i <= j + 1 && i < N; ++i) R_[i * N + j] = R_[i * N + j + 1];
  }
  for (int k = first; k < left; ++k) {
    Real* const upper_row = R_ + k * N;
    Real* const lower_row = upper_row + N;
    const Real length = square_root(upper_row[k] * upper_row[k] + lower_row[k] * lower_row[k]);
    const Real c = upper_row[k] / length;
    const Real s = lower_row[k] / length;
    const auto turn = [c, s](Real& a, Real& b) noexcept {
      const Real turned = c * a + s * b;
      b = c * b - s * a;
      a = turned;
    };
    for (int j = k; j < left; ++j) turn(upper_row[j], lower_row[j]);
    for (int i = 0; i < N; ++i) turn(Jt_[k * N + i], Jt_[(k + 1) * N + i]);
    turn(d_[k], d_[k + 1]);
  }
}

/// Moves x along the active rows until they hold, and changes their multipliers accordingly: R^T y
/// = b - B^T x, x += J_1 y, u += R^-1 y.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::correct() noexcept {
  for (int j = 0; j < count(); ++j) {
    const int row = active_[j];
    const bool is_upper = solution_.sides[row] == RowSide::upper;
    const Real value = row < N ? solution_.x[row] : dot_of<N>(rows_.A + (row - N) * N, solution_.x);
    Real y = is_upper ? value - upper(row) : lower(row) - value;
    for (int i = 0; i < j; ++i) y -= R_[i * N + j] * r_[i];
    r_[j] = y / R_[j * N + j];
  }
  add_rows(r_, Jt_, 0, count(), solution_.x);
  for (int j = count() - 1; j >= 0; --j) {
    r_[j] /= R_[j * N + j];
    for (int i = 0; i < j; ++i) r_[i] -= R_[i * N + j] * r_[j];
    u_[j] += r_[j];
  }
}

/// x and the multipliers of the active rows from the factors.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::find_multipliers() noexcept {
  for (int i = 0; i < N; ++i) solution_.x[i] = x0_[i];
  for (int j = 0; j < count(); ++j) u_[j] = Real(0);
  correct();
}

/// The minimum over the active rows, without those whose multiplier has the wrong sign.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::settle() noexcept {
  for (;;) {
    find_multipliers();
    int worst = -1;
    for (int j = 0; j < count(); ++j) {
      if (!may_leave(j) || !(u_[j] < Real(0))) continue;
      if (worst < 0 || u_[j] < u_[worst]) worst = j;
    }
    if (worst < 0) return;
    drop(worst);
    ++solution_.iterations;
  }
}

template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::set_aside(const Violation& violation) noexcept {
  solution_.sides[violation.row] = RowSide::set_aside;
  if (solution_.conflicting_row < 0) solution_.conflicting_row = violation.row;
  solution_.status = QuadraticStatus::conflicting;
  settle();
}

/// Rows are taken in until none is missed by more than rounding, also after x was computed again
/// from the factors.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::solve() noexcept {
  add_start();
  bool settled = true;
  for (;;) {
    const Violation violation = most_violated();
    if (violation.row >= 0) {
      if (left_ == 0) {
        solution_.status = QuadraticStatus::limit;
        break;
      }
      enter(violation);
      settled = false;
    } else if (!settled) {
      settle();
      settled = true;
    } else {
      break;
    }
  }
  finish();
}

template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::finish() noexcept {
  if (solution_.status == QuadraticStatus::limit) settle();
  correct();
  solution_.warm = true;
  for (int row = 0; row < kRows; ++row) solution_.multipliers[row] = Real(0);
  bool finite = true;
  for (int j = 0; j < count(); ++j) {
    const int row = active_[j];
    solution_.multipliers[row] = sign(solution_.sides[row]) * u_[j];
    finite = finite && is_finite(u_[j]);
  }
  for (int i = 0; i < N; ++i) finite = finite && is_finite(solution_.x[i]);
  if (!finite) give_up(solution_);
}

}  // namespace steps

/// Minimises 1/2 x^T H x + g^T x over `rows`; H row-major, symmetric, positive definite, of which
/// the lower triangle is read. The answer is unique, so that another start changes it by rounding
/// only; the same start gives the same bits.
template <class Real, int N, int M>
inline void solve_quadratic_program(const Real (&H)[N * N], const Real (&g)[N],
                                    const QuadraticRows<Real, N, M>& rows,
                                    QuadraticSolution<Real, N, M>& solution,
                                    int iterations = most_iterations(N, M)) noexcept {
  steps::DualActiveSet<Real, N, M> method(rows, solution, iterations);
  if (method.start(H, g)) {
    method.solve();
    return;
  }
  solution.iterations = 0;
  steps::give_up(solution);
}

/// The x nearest to `center` over `rows`: minimises |x - center|^2 / 2.
template <class Real, int N, int M>
inline void solve_least_distance(const Real (&center)[N], const QuadraticRows<Real, N, M>& rows,
                                 QuadraticSolution<Real, N, M>& solution,
                                 int iterations = most_iterations(N, M)) noexcept {
  steps::DualActiveSet<Real, N, M> method(rows, solution, iterations);
  method.start_at(center);
  method.solve();
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
