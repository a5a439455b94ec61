#include "oracle/equations.hpp"
#include "oracle/interpret.hpp"

namespace treeline {
namespace {

namespace ip = interpreter;
using At = EquationAt;

Matrix50 held_jacobian(const At& at, const Vector50& q) {
  return ip::detail::held_jacobian<Digits50>(at.model, at.subject.constraints, at.subject.loops, q);
}

Vector50 held_bias(const At& at) {
  return differentiate_rows(at, [&](const Vector50& q) { return held_jacobian(at, q); });
}

/// Where a loop's first body touches, in the world.
ip::Vector3<Digits50> touching_place(const At& at, const ip::Loop<Digits50>& loop) {
  const auto k = ip::kinematics<Digits50>(at.model, at.q,
                                          Vector50::Zero(static_cast<Eigen::Index>(at.model.nv)));
  const ip::Points<Digits50> first{loop.first};
  return ip::forward_kinematics<Digits50>(at.model, first, at.q).front().position +
         ip::detail::to_contact(*loop.rolling, ip::detail::LoopState<Digits50>(loop, k));
}

/// Velocities of a loop's rows seen from its second frame, from differences of both poses: of the
/// first frame's origin, or of the matter that touches where the loop rolls.
Vector50 differentiate_loop(const At& at, const ip::Loop<Digits50>& loop) {
  const ip::Points<Digits50> both{loop.first, loop.second};
  const Vector50 v = differentiate_poses(at, ip::with_all_rows<Digits50>(both));
  const auto poses = ip::forward_kinematics<Digits50>(at.model, both, at.q);
  const ip::Vector3<Digits50> place =
      loop.rolling ? touching_place(at, loop) : ip::Vector3<Digits50>(poses[0].position);
  const auto velocity_there = [&](Eigen::Index k) {
    const ip::Vector3<Digits50> w = v.segment<3>(6 * k + 3);
    const ip::Vector3<Digits50> arm = place - poses[static_cast<std::size_t>(k)].position;
    return ip::Vector3<Digits50>(v.segment<3>(6 * k) + ip::cross<Digits50>(w, arm));
  };
  const ip::Vector3<Digits50> moving = velocity_there(0) - velocity_there(1);
  const ip::Vector3<Digits50> turning = v.segment<3>(3) - v.segment<3>(9);
  const ip::Matrix3<Digits50> back = poses[1].rotation.transpose();
  const Vector50 all = joined(back * moving, back * turning);
  return all(ip::controlled_rows<Digits50>({loop.second}));
}

EquationSides held_rows(const At& at) {
  const auto nv = static_cast<Eigen::Index>(at.model.nv);
  const Vector50 stated = at.block(0, at.value.size() / nv, nv) * at.qd;
  Vector50 found = differentiate_poses(at, at.subject.constraints);
  for (const auto& loop : at.subject.loops.frames) {
    found = joined(found, differentiate_loop(at, loop));
  }
  const auto couplings = static_cast<Eigen::Index>(at.subject.loops.couplings.size());
  const Vector50 of_joints = rate_along(at, at.qd, [&](const Vector50& q) {
    return Vector50(ip::loop_errors<Digits50>(at.model, at.subject.loops, q).tail(couplings));
  });
  return {stated, joined(found, of_joints), at.rate};
}

/// Sides of J qdd + Jd qd = `asked` for held rows. The scale of their difference includes 1 m/s^2
/// or 1 rad/s^2.
EquationSides held_still(const At& at, const Vector50& qdd, const Vector50& asked) {
  const Vector50 driven = held_jacobian(at, at.q) * qdd;
  const Vector50 moved = held_bias(at);
  return {driven + moved, asked,
          Digits50(1) + largest_of(qdd) + largest_of(driven) + largest_of(moved)};
}

Matrix50 inverse_inertia_of_rows(const At& at, const Matrix50& J) {
  const Matrix50 M = ip::mass_matrix<Digits50>(at.model, at.q);
  return J * M.ldlt().solve(Matrix50(J.transpose()));
}

/// The share to which each held row is held.
Vector50 shares_of(const At& at, Eigen::Index rows) {
  const Vector50 shares = held_shares(at.subject, at.state);
  return shares.size() > 0 ? shares : Vector50(Vector50::Ones(rows));
}

/// Whether motors and constraints alone can give any acceleration to all rows, held or of the task:
/// M qdd = J_s^T f + tau, tau = 0 where there is no motor, has a solution for each.
bool can_do_task(const At& at, const Matrix50& J_s) {
  const Matrix50 J_t = ip::jacobian<Digits50>(at.model, at.subject.points, at.q);
  const Eigen::Index nv = J_s.cols();
  const Eigen::Index held = J_s.rows();
  Matrix50 A = Matrix50::Zero(nv + held + J_t.rows(), 2 * nv + held);
  A.topLeftCorner(nv, nv) = ip::mass_matrix<Digits50>(at.model, at.q);
  A.block(0, nv, nv, held) = J_s.transpose();
  A.topRightCorner(nv, nv).setIdentity();
  for (const int v : at.subject.passive) A(v, nv + held + v) = 0;
  A.block(nv, 0, held, nv) = J_s;
  A.bottomLeftCorner(J_t.rows(), nv) = J_t;
  return are_independent(A * A.transpose());
}

/// Sides of the equation of held rows, times the share to which each is held; none if rows depend
/// on each other, as no qdd fits each.
EquationSides constrained(const At& at) {
  const Matrix50 J = held_jacobian(at, at.q);
  const Matrix50 Lambda_inverse = inverse_inertia_of_rows(at, J);
  if (!are_independent(Lambda_inverse)) return {};
  const Vector50 gains = at.other(Quantity::stabilisation);
  const Vector50 drift = joined(at.other(Quantity::drift),
                                ip::loop_errors<Digits50>(at.model, at.subject.loops, at.q));
  EquationSides sides =
      held_still(at, at.value.head(at.model.nv), -gains(0) * (J * at.qd) - gains(1) * drift);
  const Vector50 shares = shares_of(at, J.rows());
  const Vector50 yields = (Vector50::Ones(J.rows()) - shares)
                              .cwiseProduct(Lambda_inverse.diagonal())
                              .cwiseProduct(at.value.tail(J.rows()));
  sides.stated = shares.cwiseProduct(sides.stated) + yields;
  sides.differentiated = shares.cwiseProduct(sides.differentiated);
  sides.terms += largest_of(yields);
  return sides;
}

/// Sides of the equation under the torques and the forces of constraints in the value; 0 of rows
/// that are held in part.
EquationSides supported(const At& at) {
  const Matrix50 J = held_jacobian(at, at.q);
  if (!can_do_task(at, J)) return {};
  const Vector50 tau = at.value.head(at.model.nv) + J.transpose() * at.value.tail(J.rows());
  const Vector50 qdd =
      ip::forward_dynamics<Digits50>(at.model, at.q, at.qd, tau, at.subject.external, at.f_ext);
  EquationSides sides = held_still(at, qdd, Vector50::Zero(J.rows()));
  const Vector50 shares = shares_of(at, J.rows());
  for (Eigen::Index i = 0; i < shares.size(); ++i) {
    if (shares(i) != Digits50(1)) sides.stated(i) = 0;
  }
  return sides;
}

constexpr auto kEquationsOfConstraints = std::to_array<Equation>({
    {Function::constraint_jacobian, "J_s qd = d/dt of the poses", held_rows},
    {Function::constrained_forward_dynamics, "J_s qdd + d/dt (J_s qd) = -stabilisation",
     constrained},
    {Function::supported_control_torque, "J_s qdd + d/dt (J_s qd) = 0", supported},
});

}  // namespace

std::span<const Equation> equations_of_constraints() {
  return kEquationsOfConstraints;
}

}  // namespace treeline
