#pragma once
// The program of limited_torque.hpp at one state. Its functions are in limit_coordinates.hpp and
// limited_torque.hpp.

#include "core/force_basis.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core::steps {

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

}  // namespace treeline::core::steps

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
