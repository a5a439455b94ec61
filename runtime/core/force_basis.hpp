#pragma once
// Forces of supports that balance passive joints, and those that carry nothing, for
// limited_torque.hpp.

#include "core/load_lanes.hpp"
#include "core/quadratic_sums.hpp"
#include "core/square_root.hpp"
#include "core/torque_limits.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core::steps {

/// A row that has less than this share left outside the rows before it depends on them.
template <class Real>
inline constexpr Real kRankTolerance = Real(4.6e6) * Format<Real>::kEpsilon;
template <>
inline constexpr float kRankTolerance<float> = 1e-3F;

/// W - along (v^T W) of the `width` columns that `W` points at, from row `at` on: their sums stay
/// in registers.
template <int width, int rows, int cols, class Real>
inline void reflect_columns(const Real (&v)[rows], const Real (&along)[rows], int at,
                            Real* W) noexcept {
  auto sums = Lanes<Real, width>::spread(Real(0));
  Lanes<Real, width> row;
  for (int i = at; i < rows; ++i) {
    load_lanes(W + i * cols, row);
    add_lanes(v[i] * row, sums);
  }
  for (int i = at; i < rows; ++i) {
    load_lanes(W + i * cols, row);
    store_lanes(row - along[i] * sums, W + i * cols);
  }
}

/// A reflection that maps column `column` of the row-major `W`, from row `at` on, to its first
/// entry, applied to this column and those behind it. False, and no reflection, where the column's
/// norm there is at most `least`.
template <int rows, int cols, class Real>
inline bool reflect(Real (&W)[rows * cols], int at, int column, Real least) noexcept {
  static_assert(cols % 8 == 0, "columns in eights");
  Real square = Real(0);
  for (int i = at; i < rows; ++i) square += W[i * cols + column] * W[i * cols + column];
  const Real norm = square_root(square);
  if (!(norm > least) || at >= rows) return false;
  Real v[rows];
  for (int i = at; i < rows; ++i) v[i] = W[i * cols + column];
  const Real first = v[at];
  const Real to = first > Real(0) ? -norm : norm;
  v[at] = first - to;
  const Real scale = Real(1) / (norm * (norm + size_of(first)));
  Real along[rows];
  for (int i = at; i < rows; ++i) along[i] = scale * v[i];
  int begin = column / 8 * 8;
  if constexpr (kVectorBytes > 0) {  // where there are no vectors it would only be longer
    for (; begin + 16 <= cols; begin += 16)
      reflect_columns<16, rows, cols>(v, along, at, W + begin);
  }
  for (; begin < cols; begin += 8) reflect_columns<8, rows, cols>(v, along, at, W + begin);
  W[at * cols + column] = to;
  for (int i = at + 1; i < rows; ++i) W[i * cols + column] = Real(0);
  return true;
}

/// Forces of supports that balance passive joints, d_f = carry v, and those that carry nothing,
/// d_f = free z, where v are the entries `carried` of M d_qdd; the other passive entries depend on
/// them by `relations`. With J_sp the passive columns of J_s, J_sp^T d_f = v.
template <class Real, int H, int P>
struct ForceBasis {
  int rank;               ///< of J_sp
  int carried[P];         ///< which of its columns are independent, of `rank`
  bool depends[P];        ///< the others
  Real relations[P * P];  ///< row j: parts of column j along those carried
  Real carry[H * P];      ///< H x rank
  Real free[H * H];       ///< H x (H - rank)
};

/// With [G, 1] = Q [R, Q^T], where G are the columns of J_sp that `W` begins with: carry is S Q_1
/// R_11^-T, free S Q_2, relations R_11^-1 R_12, S the roots of weights.
template <class Real, int H, int P>
inline void read_force_basis(const Real (&W)[H * in_eights(P + H)], const Real (&weights)[H],
                             int count, ForceBasis<Real, H, P>& basis) noexcept {
  constexpr int cols = in_eights(P + H);
  const auto R = [&](int r, int s) noexcept { return W[r * cols + basis.carried[s]]; };
  for (int j = 0; j < count; ++j) {
    for (int r = basis.rank - 1; r >= 0 && basis.depends[j]; --r) {
      Real part = W[r * cols + j];
      for (int s = r + 1; s < basis.rank; ++s) part -= R(r, s) * basis.relations[j * P + s];
      basis.relations[j * P + r] = part / R(r, r);
    }
  }
  for (int i = 0; i < H; ++i) {
    for (int r = basis.rank - 1; r >= 0; --r) {
      Real part = W[r * cols + P + i];
      for (int s = r + 1; s < basis.rank; ++s) part -= R(r, s) * basis.carry[i * P + s];
      basis.carry[i * P + r] = part / R(r, r);
    }
    for (int r = 0; r < basis.rank; ++r) basis.carry[i * P + r] *= weights[i];
    for (int k = basis.rank; k < H; ++k) {
      basis.free[i * H + k - basis.rank] = weights[i] * W[k * cols + P + i];
    }
  }
}

/// Of J_s, H x V, whose columns `passive` are the first `count` of P.
template <int V, class Real, int H, int P>
inline void find_force_basis(const Real (&J)[H * V], const int (&passive)[P], int count,
                             const Real (&weights)[H], ForceBasis<Real, H, P>& basis) noexcept {
  constexpr int cols = in_eights(P + H);
  Real W[H * cols];
  Real squares[P];
  for (Real& each : squares) each = Real(0);
  for (int i = 0; i < H; ++i) {
    for (int j = 0; j < P; ++j) {
      const Real entry = j < count ? weights[i] * J[i * V + passive[j]] : Real(0);
      W[i * cols + j] = entry;
      squares[j] += entry * entry;
    }
    for (int j = P; j < cols; ++j) W[i * cols + j] = i == j - P ? Real(1) : Real(0);
  }
  basis.rank = 0;
  for (int j = 0; j < count; ++j) {
    const Real least = kRankTolerance<Real> * square_root(squares[j]);
    basis.depends[j] = basis.rank >= H || !reflect<H, cols>(W, basis.rank, j, least);
    if (!basis.depends[j]) basis.carried[basis.rank++] = j;
  }
  read_force_basis(W, weights, count, basis);
}

}  // namespace treeline::core::steps

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
