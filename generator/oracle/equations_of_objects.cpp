#include "interpreter/object_control_torque.hpp"
#include "oracle/equations.hpp"

namespace treeline {
namespace {

namespace ip = interpreter;
using At = EquationAt;

/// Whether each hand can move in all ways.
bool can_move_objects(const At& at) {
  const auto points = ip::object_points(at.subject.chain, 0);
  return are_independent(ip::lambda_inverse<Digits50>(at.model, points, at.q));
}

/// Velocities [v; w] of each object by each of its grasps, from differences of poses alone.
Vector50 differentiate_grasps(const At& at) {
  return differentiate_poses(at, ip::object_points(at.subject.chain, 0));
}

/// Velocities of the objects, and what later grasps say less the first ones.
EquationSides moving_objects(const At& at) {
  const auto& objects = at.subject.chain.objects;
  const auto count = static_cast<Eigen::Index>(objects.size());
  const Vector50 by_grasps = differentiate_grasps(at);
  const Eigen::Index drifts = by_grasps.size() - 6 * count;
  Vector50 first, rates;
  Eigen::Index next = 0;
  for (const auto& object : objects) {
    const Vector50 own = by_grasps.segment(next, 6);
    first = joined(first, own);
    next += 6;
    for (std::size_t i = 1; i < object.grasps.size(); ++i) {
      rates = joined(rates, by_grasps.segment(next, 6) - own);
      next += 6;
    }
  }
  return {joined(at.value.segment(12 * count, 6 * count), at.value.tail(drifts)),
          joined(first, rates), at.rate};
}

/// Force over moment about its origin that an object needs to accelerate: the rate of its momentum
/// and of its moment about where the origin is now, less what its weight gives.
Vector50 driving_force(const ip::GraspedObject<Digits50>& object,
                       const ip::HeldPose<Digits50>& held, const Vector50& xdd,
                       const ip::Vector3<Digits50>& gravity) {
  const Vector50 v = held.v;
  const ip::Vector3<Digits50> w = v.tail<3>();
  const auto momenta = [&](const Digits50& time) {
    const Vector50 now = v + time * xdd;
    const ip::Vector3<Digits50> spin = now.tail<3>();
    const ip::Matrix3<Digits50> R = held.R + time * ip::cross_matrix(w) * held.R;
    const ip::Vector3<Digits50> arm = R * object.com;
    const ip::Vector3<Digits50> along = now.head<3>();
    const ip::Vector3<Digits50> linear = object.mass * (along + ip::cross<Digits50>(spin, arm));
    const ip::Vector3<Digits50> away = time * v.head<3>() + arm;
    const ip::Vector3<Digits50> own = R * (object.inertia * (R.transpose() * spin));
    return joined(linear, own + ip::cross<Digits50>(away, linear));
  };
  const Digits50 h = small_step(largest_of(v) + largest_of(xdd));
  const ip::Vector3<Digits50> weight = object.mass * gravity;
  const ip::Vector3<Digits50> center = held.R * object.com;
  return (momenta(h) - momenta(Digits50(-h))) / Digits50(2 * h) -
         joined(weight, ip::cross<Digits50>(center, weight));
}

/// Forces of the hands on their objects, at the objects' origins by each hand, world axes: those
/// that drive the objects and have the internal forces that are commanded.
Vector50 hand_forces(const At& at) {
  const Vector50 xdd = at.other(Quantity::xdd_object);
  const Vector50 internal = at.other(Quantity::internal);
  Vector50 all;
  Eigen::Index k = 0, used = 0;
  for (const auto& poses : ip::held_poses<Digits50>(at.subject.chain, {at.q}, {at.qd})) {
    const auto& object = at.subject.chain.objects[static_cast<std::size_t>(k)];
    const Vector50 F =
        driving_force(object, poses.front(), xdd.segment(6 * k, 6), at.model.gravity);
    const ip::Matrix3<Digits50> back = poses.front().R.transpose();
    const int count = ip::internal_force_count(static_cast<int>(object.grasps.size()));
    const Vector50 split = ip::split_over_grasps<Digits50>(
        object, joined(back * F.head<3>(), back * F.tail<3>()), internal.segment(used, count));
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const auto from = static_cast<Eigen::Index>(6 * i);
      const ip::Vector3<Digits50> force = poses[i].R * split.segment<3>(from);
      const ip::Vector3<Digits50> moment = poses[i].R * split.segment<3>(from + 3);
      all = joined(all, joined(force, moment + ip::cross<Digits50>(poses[i].to_hand, force)));
    }
    used += count;
    ++k;
  }
  return all;
}

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

/// The objects move as they are told to, by the torque that is the value, where the hands give them
/// the forces for that.
EquationSides commanded_objects(const At& at) {
  if (!can_move_objects(at)) return {};
  const auto points = ip::object_points(at.subject.chain, 0);
  const Vector50 qdd =
      ip::forward_dynamics<Digits50>(at.model, at.q, at.qd, at.value, points, -hand_forces(at));
  return object_motion(at, qdd, at.other(Quantity::xdd_object), Vector50::Zero(2));
}

constexpr auto kEquationsOfObjects = std::to_array<Equation>({
    {Function::object_state, "[v; w] = d/dt of the poses, by every grasp", moving_objects},
    {Function::object_control_torque,
     "d/dt (J qd) = C xdd where the forces of the hands are d/dt of the objects' momenta",
     commanded_objects},
    {Function::object_forward_dynamics, "d/dt (J qd) = xdd_object by every grasp",
     [](const At& at) {
       if (!can_move_objects(at)) return EquationSides{};
       const Eigen::Index objects = 6 * static_cast<Eigen::Index>(at.subject.chain.objects.size());
       return object_motion(at, at.value.head(at.model.nv), at.value.segment(at.model.nv, objects),
                            at.other(Quantity::stabilisation));
     }},
});

}  // namespace

std::span<const Equation> equations_of_objects() {
  return kEquationsOfObjects;
}

}  // namespace treeline
