#pragma once

#include <algorithm>
#include <vector>

#include "functions/function_table.hpp"
#include "interpreter/instances.hpp"
#include "interpreter/loop_instances.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/entries.hpp"
#include "oracle/subject.hpp"

// What equations of functions are tested with: derivatives of lower functions along motions of the
// robot, as differences in 50 digits. No function that states the same derivative takes part.

namespace treeline {

using Vector50 = interpreter::Vector<Digits50>;
using Matrix50 = interpreter::Matrix<Digits50>;

/// A result of a function at a state, and what its equation is made of there.
struct EquationAt {
  EquationAt(const Subject<Digits50>& of, const State& at, const std::vector<Digits50>& results);

  const Subject<Digits50>& subject;
  const interpreter::Model<Digits50>& model;
  const State& state;
  Vector50 value;  ///< all results of the function, one after the other
  Vector50 q, qd, qdd, tau, xdd_cmd, f_ext;
  Vector50 direction;  ///< of a displacement of the joints, drawn at random
  Digits50 rate;       ///< the largest of qd

  /// `rows` x `cols` numbers of the value from its entry `at` on.
  [[nodiscard]] Matrix50 block(Eigen::Index at, Eigen::Index rows, Eigen::Index cols) const;
  /// A quantity that has no member.
  [[nodiscard]] Vector50 other(Quantity quantity) const;
};

/// Both sides of an equation, and how large its terms are where both may vanish.
struct EquationSides {
  Vector50 stated, differentiated;
  Digits50 terms = 0;
};

/// A function's equation that has a derivative in it.
struct Equation {
  Function function;
  const char* text;
  EquationSides (*sides)(const EquationAt& at);
};

inline Digits50 largest_of(const Vector50& x) {
  return x.size() == 0 ? Digits50(0) : Digits50(x.cwiseAbs().maxCoeff());
}

inline Vector50 joined(const Vector50& head, const Vector50& tail) {
  Vector50 both(head.size() + tail.size());
  both << head, tail;
  return both;
}

inline Vector50 only(const Digits50& x) {
  return Vector50::Constant(1, x);
}

/// Step of a variable along which something moves at `rate`: differences over it are right to some
/// 25 digits.
inline Digits50 small_step(const Digits50& rate) {
  return Digits50(1e-14) / (Digits50(1) + rate);
}

/// d f(q) / dt of a motion with these velocities.
template <class F>
Vector50 rate_along(const EquationAt& at, const Vector50& velocities, const F& f) {
  const Digits50 h = small_step(largest_of(velocities));
  const Vector50 way = h * interpreter::position_derivative<Digits50>(at.model, at.q, velocities);
  return (f(Vector50(at.q + way)) - f(Vector50(at.q - way))) / Digits50(2 * h);
}

/// d f(q, qd) / dt of a motion with these velocities and accelerations.
template <class F>
Vector50 rate_along(const EquationAt& at, const Vector50& velocities, const Vector50& accelerations,
                    const F& f) {
  const Digits50 h = small_step(largest_of(velocities) + largest_of(accelerations));
  const Vector50 way = h * interpreter::position_derivative<Digits50>(at.model, at.q, velocities);
  const Vector50 change = h * accelerations;
  return (f(Vector50(at.q + way), Vector50(at.qd + change)) -
          f(Vector50(at.q - way), Vector50(at.qd - change))) /
         Digits50(2 * h);
}

/// Whether rows with this inverse inertia are independent, by far. If not, no force moves each as
/// it is told to.
bool are_independent(const Matrix50& Lambda_inverse);

/// Velocities of the rows of points, from differences of their poses alone.
Vector50 differentiate_poses(const EquationAt& at, const interpreter::Points<Digits50>& points);

/// Jd qd of rows: d (J(q) qd) / dt with qd as it is.
template <class Jacobian>
Vector50 differentiate_rows(const EquationAt& at, const Jacobian& jacobian) {
  return rate_along(at, at.qd, [&](const Vector50& q) { return Vector50(jacobian(q) * at.qd); });
}

/// The derivative of f(q, qd, u) by q, qd and u together along one direction, against the value: a
/// matrix of nv columns for each of these.
template <class F>
EquationSides along_one_direction(const EquationAt& at, const Vector50& u, const F& f) {
  const Vector50& by_q = at.direction;
  const Vector50 by_qd = at.direction.reverse();
  const Vector50 by_u = u.size() > 0 ? Vector50(at.direction * Digits50(2)) : Vector50();
  const Vector50 here = f(at.q, at.qd, u);
  const auto nv = static_cast<Eigen::Index>(at.model.nv);
  const Eigen::Index size = here.size() * nv;
  Vector50 stated = at.block(0, here.size(), nv) * by_q + at.block(size, here.size(), nv) * by_qd;
  if (u.size() > 0) stated += at.block(2 * size, here.size(), nv) * by_u;
  const Digits50 h = small_step(Digits50(1));
  const Vector50 way = h * interpreter::position_derivative<Digits50>(at.model, at.q, by_q);
  const Vector50 found = (f(at.q + way, at.qd + h * by_qd, u + h * by_u) -
                          f(at.q - way, at.qd - h * by_qd, u - h * by_u)) /
                         Digits50(2 * h);
  // At rest a result may vanish with its derivatives: what it is nearby tells its size then.
  const Vector50 nearby = f(at.q, at.qd + by_qd, u + by_u);
  return {stated, found, std::max(largest_of(here), largest_of(nearby))};
}

/// `direction` . tau of joint forces that move the robot with accelerations qdd, by Lagrange's
/// equations from the energies: those of Poincare where velocities are twists in the link's own
/// axes. External forces and friction are left out.
struct LagrangianForce {
  Digits50 force = 0;
  Digits50 terms = 0;  ///< sum of the sizes of its terms
};
LagrangianForce lagrangian_force(const EquationAt& at, const Vector50& qd, const Vector50& qdd);

}  // namespace treeline
