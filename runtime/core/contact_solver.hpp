#pragma once
// Impulses at several simultaneous contacts with restitution and friction. C++17, freestanding.

#include "core/orientation.hpp"

namespace treeline::core {

/// Contact law at one contact. The normal is a unit vector out of the touched body, world axes.
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
  bool converged = false;  ///< the law holds at every contact, and all results are finite
};

namespace contact_steps {

template <class Real>
constexpr Real dot(const Real* a, const Real* b) noexcept {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Real>
constexpr Real size_of(Real x) noexcept {
  return x < Real(0) ? -x : x;
}

template <class Real>
constexpr bool are_finite(const Real* x, int count) noexcept {
  bool finite = true;
  for (int i = 0; i < count; ++i) {
    finite = finite && x[i] - x[i] == Real(0);
  }
  return finite;
}

/// Whether the law has a meaning. Friction may be infinite: what touches never slides.
template <class Real>
constexpr bool is_sound(const ContactLaw<Real>& law) noexcept {
  return are_finite(law.normal, 3) && are_finite(&law.restitution, 1) &&
         are_finite(&law.parting, 1) && law.friction >= Real(0);
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
  /// Largest mobility that is 0 but for rounding.
  [[nodiscard]] constexpr Real noise() const noexcept {
    return Real(64) * Format<Real>::kEpsilon * trace();
  }
};

/// The speed along the normal that a contact must have at least afterwards.
template <class Real>
constexpr Real wanted_speed(const ContactLaw<Real>& law, Real before) noexcept {
  const Real rebound = -law.restitution * before;
  return law.parting > Real(0) && law.parting > rebound ? law.parting : rebound;
}

/// Shortens the tangential part of `y` to `longest`. Entries are divided by the largest first, so
/// that no square leaves the range of numbers.
template <class Real>
void shorten(Real (&tangential)[3], Real longest) noexcept {
  Real largest = Real(0);
  for (const Real entry : tangential) {
    largest = size_of(entry) > largest ? size_of(entry) : largest;
  }
  if (!(largest > Real(0))) {
    return;
  }
  Real share[3];
  for (int i = 0; i < 3; ++i) {
    share[i] = tangential[i] / largest;
  }
  const Real length = square_root(dot<Real>(share, share));
  if (length * largest > longest) {
    for (int i = 0; i < 3; ++i) {
      tangential[i] = longest * (share[i] / length);
    }
  }
}

/// How far one contact was from its law, m/s.
template <class Real>
struct Miss {
  Real along = Real(0), across = Real(0);
};

/// Adds the part across the normal to `next`: against the motion there, no longer than friction
/// times y_n. Returns by how much that was missed, m/s. The mobility that divides is at least the
/// largest eigenvalue across the normal, so that no step overshoots.
template <class Real>
Real relax_across(const ContactLaw<Real>& law, const Block<Real>& block, const Real* velocity,
                  const Real* y, Real y_n, Real (&next)[3]) noexcept {
  const Real* n = law.normal;
  // Where nothing moves across but rounding, friction is what the cone permits.
  const Real rest = block.trace() - block.along(n);
  const Real mobility = rest > block.noise() ? rest : block.noise();
  const Real y_before = dot(y, n);
  Real moved[3];  // velocity after the normal part's change
  for (int i = 0; i < 3; ++i) {
    moved[i] =
        velocity[i] + (y_n - y_before) * dot(block.A + (block.row + i) * block.size + block.row, n);
  }
  const Real v_n = dot<Real>(moved, n);
  Real tangential[3];
  for (int i = 0; i < 3; ++i) {
    tangential[i] = (y[i] - y_before * n[i]) - (moved[i] - v_n * n[i]) / mobility;
  }
  shorten(tangential, y_n > Real(0) ? law.friction * y_n : Real(0));
  Real miss = Real(0);
  for (int i = 0; i < 3; ++i) {
    const Real change = size_of(tangential[i] - (y[i] - y_before * n[i])) * mobility;
    miss = change > miss ? change : miss;
    next[i] += tangential[i];
  }
  return miss;
}

/// The impulse at one contact that its law asks for while all others stay: along the normal first,
/// then across it, no longer than friction times the normal part. A contact that nothing moves
/// along its normal has none.
template <class Real>
Miss<Real> relax(const ContactLaw<Real>& law, const Block<Real>& block, Real wanted,
                 const Real* velocity, const Real* y, Real (&next)[3]) noexcept {
  const Real* n = law.normal;
  const Real per_mass = block.along(n);
  const Real y_before = dot(y, n);
  const Real lack = wanted - dot(velocity, n);
  Real y_n = Real(0);
  Miss<Real> miss;
  if (per_mass > block.noise()) {
    y_n = y_before + lack / per_mass;
    y_n = y_n > Real(0) ? y_n : Real(0);
    miss.along = size_of(y_n - y_before) * per_mass;
  } else {
    miss.along = lack > Real(0) ? lack : Real(0);
  }
  for (int i = 0; i < 3; ++i) {
    next[i] = y_n * n[i];
  }
  if (law.friction > Real(0) && block.trace() > Real(0)) {
    miss.across = relax_across(law, block, velocity, y, y_n, next);
  }
  return miss;
}

/// Share of a change that is made: all, and less where impulses go to and fro, as those of oblique
/// contacts with much friction do. A part of the way between two points of a cone is in it.
template <class Real>
constexpr Real share_of_change(int sweeps) noexcept {
  constexpr int kPatience = 512;
  return Real(1) / static_cast<Real>(1 + sweeps / kPatience % 4);
}

}  // namespace contact_steps

/// Impulses `y` at `count` contacts and the velocities after them, v += A y, world axes, three
/// entries for each contact. `A` is the contact-space inverse inertia, 3k x 3k row-major, symmetric
/// and semidefinite (`contact_inverse_inertia`), `v` holds the velocities before. `wanted` is room
/// for `count` numbers.
///
/// Solved is, for each contact, Moreau's law: v_n >= -e v_n before (or `parting` where that is
/// positive and more), y_n >= 0, one of them equal; |y_t| <= friction y_n, with y_t against v_t
/// wherever the contact slides. A contact that others push back in, though it parted before, may so
/// approach: that is for the next blow. With one e for all and no friction energy never grows,
/// y . (v before + v) = (1 - e) y . v before <= 0, and stays with e = 1; Newton's law, which holds
/// such a contact at rest, would make energy. With e = 0 energy never grows either, whatever the
/// friction. With both it may where blows are oblique and coupled (Kane & Levinson 1985).
///
/// Projected Gauss-Seidel, contact by contact. Without friction that is coordinate descent of a
/// convex quadratic over y >= 0: it converges linearly from any start, to the one solution in v
/// (Luo & Tseng 1992). With friction its fixed points are exactly the law above, but neither
/// convergence nor uniqueness is certain: `converged` tells whether in the last sweep each contact
/// was within the tolerance of its law when it was visited, no impulse moved a speed by more, and
/// all results are finite. It is false where no impulse serves: a contact that approaches and that
/// nothing moves along its normal, or numbers that are not finite. `y` on entry is the start, zeros
/// or an earlier solution.
template <class Real>
ContactSolution solve_contacts(int count, const Real* A, const ContactLaw<Real>* laws, Real* v,
                               Real* y, Real* wanted,
                               const ContactSolverSettings<Real>& settings = {}) noexcept {
  const int size = 3 * count;
  Real largest = Real(0);
  bool sound = true;
  for (int c = 0; c < count; ++c) {
    sound = sound && contact_steps::is_sound(laws[c]);
    const Real before = contact_steps::dot<Real>(v + 3 * c, laws[c].normal);
    wanted[c] = contact_steps::wanted_speed(laws[c], before);
    for (int i = 0; i < 3; ++i) {
      const Real speed = contact_steps::size_of(v[3 * c + i]);
      largest = speed > largest ? speed : largest;
    }
    largest = laws[c].parting > largest ? laws[c].parting : largest;
  }
  const auto add_impulse = [&](int c, const Real(&change)[3]) {
    Real most = Real(0);
    for (int i = 0; i < size; ++i) {
      const Real moved = contact_steps::dot<Real>(A + i * size + 3 * c, change);
      most = contact_steps::size_of(moved) > most ? contact_steps::size_of(moved) : most;
      v[i] += moved;
    }
    return most;
  };
  for (int c = 0; c < count; ++c) {  // a start that is not zero has its effect
    const Real start[3] = {y[3 * c], y[3 * c + 1], y[3 * c + 2]};
    add_impulse(c, start);
  }
  ContactSolution solution;
  const Real allowed = settings.tolerance * largest;
  bool settled = false;
  while (sound && !solution.converged && solution.sweeps < settings.most_sweeps) {
    // The last sweep makes all of each change, so that impulses that vanish are 0.
    const Real share = settled ? Real(1) : contact_steps::share_of_change<Real>(solution.sweeps);
    settled = true;
    for (int c = 0; c < count; ++c) {
      const contact_steps::Block<Real> block{A, size, 3 * c};
      Real next[3];
      const contact_steps::Miss<Real> miss =
          contact_steps::relax(laws[c], block, wanted[c], v + 3 * c, y + 3 * c, next);
      Real change[3];
      for (int i = 0; i < 3; ++i) {
        change[i] = share * (next[i] - y[3 * c + i]);
        y[3 * c + i] = share < Real(1) ? y[3 * c + i] + change[i] : next[i];
      }
      const Real moved = add_impulse(c, change);
      settled = settled && moved <= allowed && miss.along <= allowed && miss.across <= allowed;
    }
    ++solution.sweeps;
    solution.converged = settled && share == Real(1);
  }
  solution.converged = solution.converged && contact_steps::are_finite(v, size) &&
                       contact_steps::are_finite(y, size);
  return solution;
}

}  // namespace treeline::core
