#pragma once
// Impulses at several simultaneous contacts with restitution and friction. C++17, freestanding.

#include "core/orientation.hpp"

namespace treeline::core {

/// What holds at one contact. The normal is a unit vector out of what is touched, world axes.
template <class Real>
struct ContactLaw {
  Real normal[3] = {Real(0), Real(0), Real(1)};
  Real restitution = Real(0);  ///< 0: the approach ends; 1: it is reversed
  Real friction = Real(0);     ///< Coulomb's coefficient, both sticking and sliding
  Real parting = Real(0);      ///< m/s, where positive the least speed along the normal afterwards
};

template <class Real>
struct ContactSolverSettings {
  int most_sweeps = 1000;
  Real tolerance = Real(1e-12);  ///< of speeds, relative to the largest before
};

struct ContactSolution {
  int sweeps = 0;
  bool converged = false;
};

namespace contact_steps {

template <class Real>
constexpr Real dot(const Real* a, const Real* b) noexcept {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// One contact's block of a 3k x 3k matrix.
template <class Real>
struct Block {
  const Real* A;
  int size;
  int row;

  /// n^T A_kk n
  [[nodiscard]] constexpr Real along(const Real* n) const noexcept {
    Real sum = Real(0);
    for (int i = 0; i < 3; ++i) {
      sum += n[i] * dot(A + (row + i) * size + row, n);
    }
    return sum;
  }
  [[nodiscard]] constexpr Real trace() const noexcept {
    return A[row * size + row] + A[(row + 1) * size + row + 1] + A[(row + 2) * size + row + 2];
  }
};

/// The speed along the normal that a contact must have at least afterwards.
template <class Real>
constexpr Real wanted_speed(const ContactLaw<Real>& law, Real before) noexcept {
  const Real rebound = -law.restitution * before;
  return law.parting > Real(0) && law.parting > rebound ? law.parting : rebound;
}

/// Shortens the tangential part of `y` to `longest`.
template <class Real>
void shorten(Real (&tangential)[3], Real longest) noexcept {
  const Real length = square_root(dot<Real>(tangential, tangential));
  if (length > longest) {
    for (Real& entry : tangential) {
      entry *= longest / length;
    }
  }
}

/// The impulse at one contact that its law asks for while all others stay: along the normal first,
/// then across it, no longer than friction times the normal part.
template <class Real>
void relax(const ContactLaw<Real>& law, const Block<Real>& block, Real wanted, const Real* velocity,
           const Real* y, Real (&next)[3]) noexcept {
  const Real* n = law.normal;
  const Real per_mass = block.along(n);
  const Real y_before = dot(y, n);
  Real y_n = y_before - (dot(velocity, n) - wanted) / per_mass;
  y_n = y_n > Real(0) ? y_n : Real(0);
  Real tangential[3];
  if (law.friction > Real(0)) {
    // Not less than the largest eigenvalue across the normal: a step that cannot overshoot.
    const Real across = block.trace() - per_mass;
    Real moved[3];  // velocity after the normal part's change
    for (int i = 0; i < 3; ++i) {
      moved[i] = velocity[i] +
                 (y_n - y_before) * dot(block.A + (block.row + i) * block.size + block.row, n);
    }
    const Real v_n = dot<Real>(moved, n);
    for (int i = 0; i < 3; ++i) {
      tangential[i] = (y[i] - y_before * n[i]) - (moved[i] - v_n * n[i]) / across;
    }
    shorten(tangential, law.friction * y_n);
  } else {
    tangential[0] = Real(0);
    tangential[1] = Real(0);
    tangential[2] = Real(0);
  }
  for (int i = 0; i < 3; ++i) {
    next[i] = y_n * n[i] + tangential[i];
  }
}

}  // namespace contact_steps

/// Impulses `y` at `count` contacts and the velocities after them, v += A y, world axes, three
/// entries for each contact. `A` is the contact-space inverse inertia, 3k x 3k row-major, symmetric
/// (`contact_inverse_inertia`), `v` holds the velocities before; every contact must be able to move
/// along its normal. `wanted` is room for `count` numbers.
///
/// Solved is, for each contact, Moreau's law: v_n >= -e v_n before (or `parting` where that is
/// positive and more), y_n >= 0, one of them equal; |y_t| <= friction y_n, with y_t against v_t
/// wherever the contact slides. A contact that others push back in, though it parted before, may so
/// approach: that is for the next blow. With one e for all and no friction energy never grows,
/// y . (v before + v) = (1 - e) y . v before <= 0, and stays with e = 1; Newton's law, which holds
/// such a contact at rest, would make energy. With friction energy may grow where blows are oblique
/// and coupled (Kane & Levinson 1985).
///
/// Projected Gauss-Seidel, contact by contact. Without friction that is coordinate descent of a
/// convex quadratic over y >= 0: it converges linearly from any start, to the one solution in v
/// (Luo & Tseng 1992). With friction its fixed points are exactly the law above, but neither
/// convergence nor uniqueness is certain: `converged` tells whether no impulse moved a speed by
/// more than the tolerance in the last sweep. `y` on entry is the start, zeros or an earlier
/// solution.
template <class Real>
ContactSolution solve_contacts(int count, const Real* A, const ContactLaw<Real>* laws, Real* v,
                               Real* y, Real* wanted,
                               const ContactSolverSettings<Real>& settings = {}) noexcept {
  const int size = 3 * count;
  Real largest = Real(0);
  for (int c = 0; c < count; ++c) {
    const Real before = contact_steps::dot<Real>(v + 3 * c, laws[c].normal);
    wanted[c] = contact_steps::wanted_speed(laws[c], before);
    for (int i = 0; i < 3; ++i) {
      const Real speed = v[3 * c + i] < Real(0) ? -v[3 * c + i] : v[3 * c + i];
      largest = speed > largest ? speed : largest;
    }
    largest = laws[c].parting > largest ? laws[c].parting : largest;
  }
  const auto add_impulse = [&](int c, const Real(&change)[3]) {
    for (int i = 0; i < size; ++i) {
      v[i] += contact_steps::dot<Real>(A + i * size + 3 * c, change);
    }
  };
  for (int c = 0; c < count; ++c) {  // a start that is not zero has its effect
    const Real start[3] = {y[3 * c], y[3 * c + 1], y[3 * c + 2]};
    add_impulse(c, start);
  }
  ContactSolution solution;
  while (!solution.converged && solution.sweeps < settings.most_sweeps) {
    Real most = Real(0);
    for (int c = 0; c < count; ++c) {
      const contact_steps::Block<Real> block{A, size, 3 * c};
      Real next[3];
      contact_steps::relax(laws[c], block, wanted[c], v + 3 * c, y + 3 * c, next);
      Real change[3];
      for (int i = 0; i < 3; ++i) {
        change[i] = next[i] - y[3 * c + i];
        const Real moved = (change[i] < Real(0) ? -change[i] : change[i]) * block.trace();
        most = moved > most ? moved : most;
        y[3 * c + i] = next[i];
      }
      add_impulse(c, change);
    }
    ++solution.sweeps;
    solution.converged = most <= settings.tolerance * largest;
  }
  return solution;
}

}  // namespace treeline::core
