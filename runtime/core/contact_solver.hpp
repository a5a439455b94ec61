#pragma once
// Impulses at several simultaneous contacts with restitution and friction, see
// runtime/emitted/contact_solver.h. C++17, freestanding, no heap, a bounded number of steps.

#include <stdbool.h>
#include <stdint.h>

#include "core/emitted_limits.hpp"
#include "core/square_root.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

#define TL_INLINE static inline
#define TL_FUNCTION static inline

/// 10^exponent, exact as far as `Real` holds it.
template <class Real>
constexpr Real power_of_ten(int exponent) {
  return exponent == 0 ? Real(1) : Real(10) * power_of_ten<Real>(exponent - 1);
}

/// Everything of runtime/emitted/contact_solver.h, for at most so many contacts.
template <class Number, int room, int digits>
struct EmittedContacts {
  using real = Number;
  static constexpr real TL_ZERO = real(0), TL_HALF = real(0.5), TL_ONE = real(1), TL_TWO = real(2),
                        TL_TEN = real(10);
  static constexpr int32_t TL_CONTACTS = room, TL_FEW_CONTACTS = room,
                           TL_CONTACT_ROWS = in_eights(3 * room);
  static constexpr bool kDouble = sizeof(real) >= sizeof(double);
  static constexpr real TL_ROUNDING = Format<real>::kEpsilon,
                        TL_CONTACT_TOLERANCE = TL_ONE / power_of_ten<real>(kDouble ? digits : 5),
                        TL_TOLERANCE_OF_MANY = TL_CONTACT_TOLERANCE,
                        TL_CONTACT_SHIFT = real(kDouble ? 1e-12 : 1e-5),
                        TL_LARGEST_FRICTION = real(kDouble ? 1e6 : 1e3);

  static real tl_square_root(real x) { return square_root(x); }

#include "emitted/contact_solver.h"
};

#undef TL_INLINE
#undef TL_FUNCTION

/// Contact law at one contact: `normal`, a unit vector out of the touched body, world axes;
/// `restitution`, 0 where the approach ends, 1 where it is reversed; `friction`, Coulomb's
/// coefficient, both sticking and sliding, of which 1e6 (in float 1e3) and more are the same.
template <class Real>
struct ContactLaw {
  Real normal[3] = {Real(0), Real(0), Real(1)};
  Real restitution = Real(0);
  Real friction = Real(0);
};

/// What became of contacts.
template <class Real>
struct ContactSolution {
  bool converged = false;  ///< all laws hold with this `restitution`, and all results are finite
  int steps = 0;           ///< sweeps, Newton steps and interior-point steps
  Real miss = Real(0);     ///< m/s, the largest miss of a law by the impulses that were found
  Real restitution = Real(1);  ///< the share of all coefficients that energy left, 1 to 0
};

/// The most steps of any problem.
inline constexpr int kMostContactSteps = 5 * 13 * (4 + 10 * 9 + 40 + 4 * 6);

/// Impulses at up to `most` contacts, in double to `digits` digits. The object is the memory that
/// the method takes.
template <class Real, int most, int digits = 12>
class ContactSolver {
 public:
  /// Impulses `y` at `count` contacts and the velocities after them, v += A y, world axes, three
  /// entries for each contact. `A` is the contact-space inverse inertia, 3k x 3k row-major,
  /// symmetric and semidefinite (`contact_inverse_inertia`), `v` holds the velocities before. `y`
  /// on entry is the start, zeros or an earlier solution.
  ///
  /// Solved is, for each contact, Moreau's law: v_n >= -e v_n before, y_n >= 0, one of them equal;
  /// |y_t| <= friction y_n, with y_t against v_t wherever the contact slides. `converged` says that
  /// every contact meets its law within 10^-digits (in float 1e-5) of the largest speed before, or
  /// within ten units of rounding of A y, whatever the masses. Where several solutions exist it is
  /// one of them.
  ///
  /// Energy never grows, y . (v before + v) <= 0 but for rounding, converged or not. With friction
  /// and restitution Newton's law may make energy where blows are oblique and coupled (Kane &
  /// Levinson 1985), or have no solution: then all coefficients of restitution are halved, at the
  /// fourth time or without a solution set to zero, where neither happens. Impulses that do not
  /// converge are those that came nearest, shortened where they would make energy.
  ContactSolution<Real> solve(int count, const Real* A, const ContactLaw<Real>* laws, Real* v,
                              Real* y) noexcept {
    for (int c = 0; c < count; ++c) {
      for (int i = 0; i < 3; ++i) laws_[c].normal[i] = laws[c].normal[i];
      laws_[c].restitution = laws[c].restitution;
      laws_[c].friction = laws[c].friction;
    }
    const auto found = Method::tl_solve_contacts(&contacts_, count, A, laws_, v, y);
    return {found.converged, found.steps, found.miss, found.restitution};
  }

 private:
  using Method = EmittedContacts<Real, most, digits>;
  typename Method::TlContacts contacts_;
  typename Method::TlContactLaw laws_[most];
};

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
