#include "oracle/equations.hpp"
#include "oracle/interpret_constraints.hpp"

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

/// Velocities of a loop's rows seen from its second frame, from differences of both poses; as
/// stated where material points are in contact, which no pose gives.
Vector50 differentiate_loop(const At& at, const ip::Loop<Digits50>& loop, const Vector50& stated) {
  if (loop.rolling) return stated;
  ip::Points<Digits50> both{loop.first, loop.second};
  const Vector50 v = differentiate_poses(at, ip::with_all_rows<Digits50>(both));
  const auto poses = ip::forward_kinematics<Digits50>(at.model, both, at.q);
  const ip::Vector3<Digits50> apart = poses[0].position - poses[1].position;
  const ip::Vector3<Digits50> w = v.segment<3>(9);
  const ip::Vector3<Digits50> turning = v.segment<3>(3) - w;
  const ip::Vector3<Digits50> moving =
      v.segment<3>(0) - v.segment<3>(6) - ip::cross<Digits50>(w, apart);
  const ip::Matrix3<Digits50> back = poses[1].rotation.transpose();
  const Vector50 all = joined(back * moving, back * turning);
  return all(ip::controlled_rows<Digits50>({loop.second}));
}

EquationSides held_rows(const At& at) {
  const auto nv = static_cast<Eigen::Index>(at.model.nv);
  const Vector50 stated = at.block(0, at.value.size() / nv, nv) * at.qd;
  Vector50 found = differentiate_poses(at, at.subject.constraints);
  for (const auto& loop : at.subject.loops.frames) {
    const int rows = ip::row_count<Digits50>({loop.second});
    found = joined(found, differentiate_loop(at, loop, stated.segment(found.size(), rows)));
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

bool can_move_rows(const At& at, const Matrix50& J) {
  const Matrix50 M = ip::mass_matrix<Digits50>(at.model, at.q);
  return are_independent(J * M.ldlt().solve(Matrix50(J.transpose())));
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

/// Sides of the equation of held rows; none if rows depend on each other, as no qdd fits each.
EquationSides constrained(const At& at) {
  if (!can_move_rows(at, held_jacobian(at, at.q))) return {};
  const Vector50 gains = at.other(Quantity::stabilisation);
  const Vector50 drift = joined(at.other(Quantity::drift),
                                ip::loop_errors<Digits50>(at.model, at.subject.loops, at.q));
  return held_still(at, at.value.head(at.model.nv),
                    -gains(0) * (held_jacobian(at, at.q) * at.qd) - gains(1) * drift);
}

/// Whether each hand can move in all ways.
bool can_move_objects(const At& at) {
  const auto points = ip::object_points(at.subject.chain, 0);
  return are_independent(ip::lambda_inverse<Digits50>(at.model, points, at.q));
}

/// Sides of the equation under the torques and the forces of constraints in the value.
EquationSides supported(const At& at) {
  const Matrix50 J = held_jacobian(at, at.q);
  if (!can_do_task(at, J)) return {};
  const Vector50 tau = at.value.head(at.model.nv) + J.transpose() * at.value.tail(J.rows());
  const Vector50 qdd =
      ip::forward_dynamics<Digits50>(at.model, at.q, at.qd, tau, at.subject.external, at.f_ext);
  return held_still(at, qdd, Vector50::Zero(J.rows()));
}

/// Velocities [v; w] of the objects by each of their grasps.
Vector50 grasp_velocities(const At& at, const Vector50& q, const Vector50& qd) {
  Vector50 all;
  for (const auto& held : ip::held_poses<Digits50>(at.subject.chain, {q}, {qd})) {
    for (const auto& pose : held) all = joined(all, pose.v);
  }
  return all;
}

/// Accelerations that each grasp asks of its object if all move as `of_objects` says, with those
/// that bring later grasps back to the first.
Vector50 by_grasp(const At& at, const Vector50& of_objects, const Vector50& gains) {
  Vector50 all;
  Eigen::Index k = 0;
  for (const auto& held : ip::held_poses<Digits50>(at.subject.chain, {at.q}, {at.qd})) {
    for (const auto& pose : held) {
      const auto drift = ip::grasp_drift<Digits50>(held.front(), pose);
      all = joined(all, of_objects.segment(6 * k, 6) - gains(0) * Vector50(drift.velocity) -
                            gains(1) * Vector50(drift.pose));
    }
    ++k;
  }
  return all;
}

EquationSides object_motion(const At& at, const Vector50& qdd, const Vector50& of_objects,
                            const Vector50& gains) {
  const auto velocities = [&](const Vector50& q, const Vector50& qd) {
    return grasp_velocities(at, q, qd);
  };
  return {by_grasp(at, of_objects, gains), rate_along(at, at.qd, qdd, velocities),
          Digits50(1) + largest_of(qdd) + at.rate * at.rate};
}

constexpr auto kEquationsOfConstraints = std::to_array<Equation>({
    {Function::constraint_jacobian, "J_s qd = d/dt of the poses", held_rows},
    {Function::constrained_forward_dynamics, "J_s qdd + d/dt (J_s qd) = -stabilisation",
     constrained},
    {Function::supported_control_torque, "J_s qdd + d/dt (J_s qd) = 0", supported},
    {Function::object_forward_dynamics, "d/dt (J qd) = xdd_object by every grasp",
     [](const At& at) {
       if (!can_move_objects(at)) return EquationSides{};
       const Eigen::Index objects = 6 * static_cast<Eigen::Index>(at.subject.chain.objects.size());
       return object_motion(at, at.value.head(at.model.nv), at.value.segment(at.model.nv, objects),
                            at.other(Quantity::stabilisation));
     }},
});

}  // namespace

std::span<const Equation> equations_of_constraints() {
  return kEquationsOfConstraints;
}

}  // namespace treeline
