#pragma once
// The state of the dual active-set method of quadratic_program.hpp: x, the active rows, their
// multipliers and factors. Its functions are in active_row_factors.hpp and enter_violated_rows.hpp.

#include "core/quadratic_rows.hpp"
#include "core/quadratic_sums.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core::steps {

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
  [[nodiscard]] bool is_comparable(int row) const noexcept;
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

}  // namespace treeline::core::steps

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
