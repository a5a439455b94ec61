#pragma once
// Torques of motors within their limits, forces of supports within their friction cones. C++17,
// freestanding, no heap, a stated bound on the work.
//
// tau and f of an unlimited law obey M qdd + h = S^T tau + J_s^T f and J_s qdd + Jd_s qd = 0. All
// that can be changed about them keeps both:
//
//     M d_qdd = S^T d_tau + J_s^T d_f,   J_s d_qdd = 0.
//
// Of all changes that bring tau and f within their limits, the one of least cost is taken:
//
//     1/2 k^2 |d_xdd|^2_D + 1/2 d_qdd^T M d_qdd + 1/2 |d_z|^2 / (k^2 m) + penalty(slack)
//
// d_xdd = J_t d_qdd is what the task loses, D its effective masses, z the forces that carry nothing
// (internal forces of two feet). k is large, so that forces give way first, then the posture, then
// the task: the limit k -> infinity is the strict hierarchy of Escande, Mansard & Wieber (2014)
// with limits above tasks above the posture of Sentis & Khatib (2005) above forces. In that limit
// the costs of the unlimited law and those here have the same minimum: the unlimited law's gradient
// is J_t^T and J_s^T times its multipliers, which is constant where d_xdd is fixed. Where no limit
// is reached nothing is changed, to the bit.
//
// Torque limits can always be kept: any torques are followed by some motion. Where they leave no
// forces within the cones, all cones are widened by the same force, `slack`, as little as possible:
// an exact penalty, so that it is zero where forces within the cones exist.
//
// The quadratic program is one of least distance in coordinates x in which the cost is |x|^2. With
// M = L L^T and d_qdd = L^-T a, the rows J_s L^-T are triangularised by reflections of a, then
// those of the task; what is left is the posture. So there is no equation left, and as few unknowns
// as motors and internal forces.

#include "core/quadratic_program.hpp"

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
  Real lost[one_or(Sizes::kTask)];  ///< xdd that the task rows lack of the unlimited law
  int iterations;
  QuadraticSolution<Real, Sizes::kUnknowns, Sizes::kRows> program;
};

/// k of the cost.
template <class Real>
inline constexpr Real kHierarchy = Real(1000);
template <>
inline constexpr float kHierarchy<float> = 30.0F;

namespace steps {

/// A row that has less than this share left outside the rows before it depends on them.
template <class Real>
inline constexpr Real kRankTolerance = Real(4.6e6) * Format<Real>::kEpsilon;
template <>
inline constexpr float kRankTolerance<float> = 1e-3F;

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
  const int begin = column / 8 * 8;
  Real sums[cols];
  for (int j = begin; j < cols; ++j) sums[j] = Real(0);
  for (int i = at; i < rows; ++i) {
    const Real* const row = W + i * cols;
    for (int j = begin; j < cols; ++j) sums[j] += v[i] * row[j];
  }
  for (int i = at; i < rows; ++i) {
    Real* const row = W + i * cols;
    const Real along = scale * v[i];
    for (int j = begin; j < cols; ++j) row[j] -= along * sums[j];
  }
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

template <class Real, class Sizes>
inline bool is_passive(const SupportLayout<Real, Sizes>& layout, int velocity) noexcept {
  bool passive = false;
  for (int j = 0; j < Sizes::kPassive; ++j) passive |= layout.passive[j] == velocity;
  return passive;
}

template <class Real>
constexpr Real clipped(Real x, Real most) noexcept {
  return x > most ? most : x < -most ? Real(-most) : x;
}

/// The program of least distance at one state.
template <class Real, class Sizes>
class LimitProgram {
 public:
  static constexpr int V = Sizes::kVelocities, P = one_or(Sizes::kPassive);
  static constexpr int H = one_or(Sizes::kHeld), T = one_or(Sizes::kTask);
  static constexpr int N = Sizes::kUnknowns;

  /// Coordinates of all changes that keep the equations.
  void set_up(const SupportLayout<Real, Sizes>& layout, const TorqueLimits<Real, Sizes>& limits,
              const Real (&M)[V * V], const Real (&J_s)[H * V], const Real (&J_t)[T * V]) noexcept;
  /// Rows of the torques' and cones' changes, and what is left to the limits.
  void limit(const SupportLayout<Real, Sizes>& layout, const TorqueLimits<Real, Sizes>& limits,
             const Real (&J_s)[H * V], const Real (&tau)[V], const Real (&f)[H]) noexcept;
  /// Changes tau and f, and tells what became of the limits.
  void solve(const SupportLayout<Real, Sizes>& layout, const TorqueLimits<Real, Sizes>& limits,
             Real (&tau)[V], Real (&f)[H], LimitedTorque<Real, Sizes>& result) noexcept;

 private:
  // Columns of `W_`: rows by which passive joints depend on each other, held rows, task rows, M.
  static constexpr int kHeldAt = P, kTaskAt = P + H, kMassAt = P + H + T;
  static constexpr int kCols = in_eights(kMassAt + V);

  void factor_mass(const Real (&M)[V * V]) noexcept;
  void whiten(const Real (&J_s)[H * V], const Real (&J_t)[T * V]) noexcept;
  void relate_passive(const SupportLayout<Real, Sizes>& layout) noexcept;
  void reduce(const Real (&weights)[T]) noexcept;
  void weigh_task(const Real (&weights)[T]) noexcept;
  void form_forces(const SupportLayout<Real, Sizes>& layout) noexcept;
  void read_column(int velocity, Real* column) const noexcept;
  void add_cones(const TorqueLimits<Real, Sizes>& limits, const Real (&f)[H]) noexcept;

  Real W_[V * kCols];
  Real squares_[kCols];  ///< of columns, before reflections
  Real heaviest_;        ///< of the diagonal of M
  int held_, task_;      ///< ranks of the rows of constraints, and of the task besides
  ForceBasis<Real, H, P> basis_;
  Real forces_[H * N];  ///< d_f by unknowns
  Real slack_;          ///< N, per unit of the last unknown
  QuadraticRows<Real, N, Sizes::kRows> rows_;
  Real center_[N];
};

/// L of M = L L^T, transposed, as the last columns of W.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::factor_mass(const Real (&M)[V * V]) noexcept {
  heaviest_ = Real(0);
  for (int k = 0; k < V; ++k) {
    heaviest_ = larger_of(heaviest_, M[k * V + k]);
    for (int j = 0; j < V; ++j) {
      W_[k * kCols + kMassAt + j] = j < k ? Real(0) : M[k * V + j];
    }
    for (int j = kMassAt + V; j < kCols; ++j) W_[k * kCols + j] = Real(0);
  }
  for (int k = 0; k < V; ++k) {
    Real* const row = W_ + k * kCols + kMassAt;
    const Real inverse = Real(1) / square_root(row[k]);
    Real scaled[V];
    for (int j = 0; j < V; ++j) scaled[j] = j < k ? Real(0) : row[j] * inverse;
    for (int j = 0; j < V; ++j) row[j] = scaled[j];
    for (int i = k + 1; i < V; ++i) {
      Real* const other = W_ + i * kCols + kMassAt;
      const Real factor = scaled[i];
      for (int j = 0; j < V; ++j) other[j] -= factor * scaled[j];
    }
  }
}

/// L^-1 J^T of held rows and tasks.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::whiten(const Real (&J_s)[H * V],
                                       const Real (&J_t)[T * V]) noexcept {
  for (int k = 0; k < V; ++k) {
    Real row[H + T];
    for (int h = 0; h < H; ++h) row[h] = h < Sizes::kHeld ? J_s[h * V + k] : Real(0);
    for (int t = 0; t < T; ++t) row[H + t] = t < Sizes::kTask ? J_t[t * V + k] : Real(0);
    for (int m = 0; m < k; ++m) {
      const Real* const before = W_ + m * kCols;
      const Real factor = before[kMassAt + k];
      for (int j = 0; j < H + T; ++j) row[j] -= factor * before[kHeldAt + j];
    }
    const Real inverse = Real(1) / W_[k * kCols + kMassAt + k];
    for (int j = 0; j < H + T; ++j) W_[k * kCols + kHeldAt + j] = row[j] * inverse;
  }
}

/// Passive entries of M d_qdd that no force of a support balances vanish.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::relate_passive(const SupportLayout<Real, Sizes>& layout) noexcept {
  for (int k = 0; k < V; ++k) {
    Real* const row = W_ + k * kCols;
    for (int j = 0; j < P; ++j) {
      row[j] = Real(0);
      if (j >= Sizes::kPassive || !basis_.depends[j]) continue;
      row[j] = row[kMassAt + layout.passive[j]];
      for (int r = 0; r < basis_.rank; ++r) {
        row[j] -= basis_.relations[j * P + r] * row[kMassAt + layout.passive[basis_.carried[r]]];
      }
    }
  }
}

/// Reflects a so that equations concern its first entries only, tasks the next.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::reduce(const Real (&weights)[T]) noexcept {
  for (Real& each : squares_) each = Real(0);
  for (int k = 0; k < V; ++k) {
    for (int j = 0; j < kMassAt; ++j) squares_[j] += W_[k * kCols + j] * W_[k * kCols + j];
  }
  held_ = 0;
  task_ = 0;
  for (int j = 0; j < kMassAt; ++j) {
    const int at = held_ + task_;
    const Real least = kRankTolerance<Real> * square_root(squares_[j]);
    if (at >= V || !reflect<V, kCols>(W_, at, j, least)) continue;
    ++(j < kTaskAt ? held_ : task_);
  }
  weigh_task(weights);
}

/// Unknowns of the task such that their squares are its cost: with K K^T = 1 + k^2 R D R^T, rows of
/// the task become K^-1 times what they are.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::weigh_task(const Real (&weights)[T]) noexcept {
  Real K[T * T];
  Real scales[T];
  for (int t = 0; t < T; ++t) {
    const Real square = squares_[kTaskAt + t];
    scales[t] =
        square > Real(0) ? weights[t] * kHierarchy<Real> * kHierarchy<Real> / square : Real(0);
  }
  for (int i = 0; i < task_; ++i) {
    Real* const row = W_ + (held_ + i) * kCols;
    for (int j = 0; j <= i; ++j) {
      const Real* const other = W_ + (held_ + j) * kCols;
      Real entry = i == j ? Real(1) : Real(0);
      for (int t = 0; t < T; ++t) entry += row[kTaskAt + t] * scales[t] * other[kTaskAt + t];
      K[i * T + j] = entry;
    }
  }
  for (int j = 0; j < task_; ++j) {
    K[j * T + j] = square_root(K[j * T + j]);
    for (int i = j + 1; i < task_; ++i) K[i * T + j] /= K[j * T + j];
    for (int i = j + 1; i < task_; ++i) {
      for (int k = j + 1; k <= i; ++k) K[i * T + k] -= K[i * T + j] * K[k * T + j];
    }
  }
  for (int i = 0; i < task_; ++i) {
    Real* const place = W_ + (held_ + i) * kCols + kTaskAt;
    Real row[T + V];
    for (int j = 0; j < T + V; ++j) row[j] = place[j];
    for (int m = 0; m < i; ++m) {
      const Real* const before = W_ + (held_ + m) * kCols + kTaskAt;
      const Real factor = K[i * T + m];
      for (int j = 0; j < T + V; ++j) row[j] -= factor * before[j];
    }
    const Real inverse = Real(1) / K[i * T + i];
    for (int j = 0; j < T + V; ++j) place[j] = row[j] * inverse;
  }
}

template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::set_up(const SupportLayout<Real, Sizes>& layout,
                                       const TorqueLimits<Real, Sizes>& limits,
                                       const Real (&M)[V * V], const Real (&J_s)[H * V],
                                       const Real (&J_t)[T * V]) noexcept {
  basis_.rank = 0;
  for (bool& each : basis_.depends) each = true;
  if (Sizes::kHeld > 0) {
    find_force_basis<V>(J_s, layout.passive, Sizes::kPassive, layout.force_weights, basis_);
  }
  factor_mass(M);
  whiten(J_s, J_t);
  relate_passive(layout);
  reduce(limits.task_weights);
  form_forces(layout);
}

/// d_f by unknowns: those that balance a motion, then those that carry nothing, then the slack.
/// Freedoms beyond those of ordinary states are left alone.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::form_forces(const SupportLayout<Real, Sizes>& layout) noexcept {
  const int moving = V - held_;
  const Real size = kHierarchy<Real> * square_root(heaviest_);
  Real carried[P * N];
  for (int r = 0; r < basis_.rank; ++r) {
    read_column(layout.passive[basis_.carried[r]], carried + r * N);
  }
  for (int h = 0; h < H; ++h) {
    Real* const row = forces_ + h * N;
    for (int n = 0; n < N; ++n) row[n] = Real(0);
    for (int r = 0; r < basis_.rank; ++r) {
      const Real factor = basis_.carry[h * P + r];
      for (int n = 0; n < N; ++n) row[n] += factor * carried[r * N + n];
    }
    for (int k = 0; k < H - basis_.rank && Sizes::kHeld > 0 && moving + k < Sizes::kFreedoms; ++k) {
      row[moving + k] = size * basis_.free[h * H + k];
    }
  }
}

/// M d_qdd at a velocity, by unknowns.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::read_column(int velocity, Real* column) const noexcept {
  const int moving = V - held_ < Sizes::kFreedoms ? V - held_ : Sizes::kFreedoms;
  const Real* const first = W_ + held_ * kCols + kMassAt + velocity;
  for (int n = 0; n < N; ++n) column[n] = Real(0);
  for (int n = 0; n < moving; ++n) column[n] = first[n * kCols];
}

template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::limit(const SupportLayout<Real, Sizes>& layout,
                                      const TorqueLimits<Real, Sizes>& limits,
                                      const Real (&J_s)[H * V], const Real (&tau)[V],
                                      const Real (&f)[H]) noexcept {
  int row = 0;
  for (int v = 0; v < V && row < Sizes::kMotors; ++v) {
    if (is_passive(layout, v)) continue;
    Real a[N];
    read_column(v, a);
    for (int h = 0; h < Sizes::kHeld; ++h) {
      const Real factor = J_s[h * V + v];
      if (factor == Real(0)) continue;
      for (int n = 0; n < N; ++n) a[n] -= factor * forces_[h * N + n];
    }
    for (int n = 0; n < N; ++n) rows_.A[row * N + n] = a[n];
    rows_.lower[row] = -limits.torque[v] - tau[v];
    rows_.upper[row] = limits.torque[v] - tau[v];
    ++row;
  }
  add_cones(limits, f);
}

/// Rows of cones, and the slack with its penalty c s + c / (2 m g) s^2: c is above any multiplier
/// of the rows that costs of the task give rise to, per N.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::add_cones(const TorqueLimits<Real, Sizes>& limits,
                                          const Real (&f)[H]) noexcept {
  const Real penalty = Real(1e4) * kHierarchy<Real> * kHierarchy<Real>;
  const Real weight = Real(10) * heaviest_;
  slack_ = square_root(weight / penalty);
  for (int c = 0; c < Sizes::kCones; ++c) {
    const ConeRow<Real>& cone = limits.cones[c];
    Real a[N];
    Real room = cone.bound;
    for (int n = 0; n < N; ++n) a[n] = Real(0);
    for (int k = 0; k < cone.count; ++k) {
      const Real factor = cone.coefficients[k];
      room -= factor * f[cone.first + k];
      for (int n = 0; n < N; ++n) a[n] += factor * forces_[(cone.first + k) * N + n];
    }
    a[Sizes::kSlackAt] = -slack_;
    for (int n = 0; n < N; ++n) rows_.A[(Sizes::kMotors + c) * N + n] = a[n];
    rows_.lower[Sizes::kMotors + c] = -kNoLimit<Real>;
    rows_.upper[Sizes::kMotors + c] = room;
  }
  for (int n = 0; n < N; ++n) {
    rows_.lowest[n] = -kNoLimit<Real>;
    rows_.highest[n] = kNoLimit<Real>;
    center_[n] = Real(0);
  }
  rows_.lowest[Sizes::kSlackAt] = Real(0);
  center_[Sizes::kSlackAt] = -weight / slack_;
}

/// tau and f with their changes, and torques within their limits to the last bit.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::solve(const SupportLayout<Real, Sizes>& layout,
                                      const TorqueLimits<Real, Sizes>& limits, Real (&tau)[V],
                                      Real (&f)[H], LimitedTorque<Real, Sizes>& result) noexcept {
  solve_least_distance(center_, rows_, result.program);
  const Real(&x)[N] = result.program.x;
  result.status = result.program.status;
  result.iterations = result.program.iterations;
  result.slack = larger_of(slack_ * x[Sizes::kSlackAt], Real(0));
  for (int t = 0; t < T; ++t) {
    result.lost[t] = Real(0);
    for (int i = 0; i < task_; ++i) result.lost[t] += W_[(held_ + i) * kCols + kTaskAt + t] * x[i];
  }
  for (int h = 0; h < Sizes::kHeld; ++h) f[h] += dot_of<N>(forces_ + h * N, x);
  int row = 0;
  for (int v = 0; v < V && row < Sizes::kMotors; ++v) {
    if (is_passive(layout, v)) continue;
    tau[v] = clipped(tau[v] + dot_of<N>(rows_.A + row * N, x), limits.torque[v]);
    ++row;
  }
}

/// Whether all that can be limited is within its limits, but for rounding of cones.
template <class Real, class Sizes>
inline bool is_within(const TorqueLimits<Real, Sizes>& limits,
                      const Real (&tau)[Sizes::kVelocities],
                      const Real (&f)[one_or(Sizes::kHeld)]) noexcept {
  bool within = true;
  for (int v = 0; v < Sizes::kVelocities; ++v) within &= size_of(tau[v]) <= limits.torque[v];
  for (int c = 0; c < Sizes::kCones; ++c) {
    const ConeRow<Real>& cone = limits.cones[c];
    Real value = Real(0);
    for (int k = 0; k < cone.count; ++k) value += cone.coefficients[k] * f[cone.first + k];
    within &= value <= cone.bound;
  }
  return within;
}

template <class Real, class Sizes>
inline void report_unlimited(LimitedTorque<Real, Sizes>& result) noexcept {
  result.limited = false;
  result.status = QuadraticStatus::solved;
  result.slack = Real(0);
  result.iterations = 0;
  for (Real& each : result.lost) each = Real(0);
  result.program.warm = false;
}

template <int count, class Real>
inline bool all_finite(const Real* numbers) noexcept {
  bool finite = true;
  for (int i = 0; i < count; ++i) finite &= is_finite(numbers[i]);
  return finite;
}

}  // namespace steps

/// Changes `tau` and `f` of an unlimited law as little as their limits permit. `matrices(M, J_s,
/// J_t)` writes the mass matrix, the Jacobian of the held rows and that of the task rows, and is
/// called only where a limit is exceeded. Torques are within their limits whatever happens; where
/// numbers do not fit the type they are clipped only, and the status is `not_convex`.
template <class Real, class Sizes, class Matrices>
inline void limit_torque(const SupportLayout<Real, Sizes>& layout,
                         const TorqueLimits<Real, Sizes>& limits, const Matrices& matrices,
                         Real (&tau)[Sizes::kVelocities], Real (&f)[one_or(Sizes::kHeld)],
                         LimitedTorque<Real, Sizes>& result) noexcept {
  constexpr int V = Sizes::kVelocities;
  constexpr int H = one_or(Sizes::kHeld);
  if (steps::is_within(limits, tau, f)) {
    steps::report_unlimited(result);
    return;
  }
  steps::LimitProgram<Real, Sizes> program;
  Real M[V * V];
  Real J_s[H * V];
  Real J_t[one_or(Sizes::kTask) * V];
  matrices(M, J_s, J_t);
  Real changed_tau[V];
  Real changed_f[H];
  for (int v = 0; v < V; ++v) changed_tau[v] = tau[v];
  for (int h = 0; h < H; ++h) changed_f[h] = f[h];
  program.set_up(layout, limits, M, J_s, J_t);
  program.limit(layout, limits, J_s, tau, f);
  program.solve(layout, limits, changed_tau, changed_f, result);
  result.limited = true;
  if (!steps::all_finite<V>(changed_tau) || !steps::all_finite<H>(changed_f)) {
    steps::report_unlimited(result);
    result.limited = true;
    result.status = QuadraticStatus::not_convex;
    for (int v = 0; v < V; ++v) tau[v] = steps::clipped(tau[v], limits.torque[v]);
    return;
  }
  for (int v = 0; v < V; ++v) tau[v] = changed_tau[v];
  for (int h = 0; h < H; ++h) f[h] = changed_f[h];
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
