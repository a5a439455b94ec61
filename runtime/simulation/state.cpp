#include "simulation/state.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "core/orientation.hpp"
#include "interpreter/instances.hpp"

namespace treeline::simulation {
namespace {

using Quaternion = Eigen::Vector4d;  // x y z w

/// Quaternion product a b: the rotation b followed by a.
Quaternion product(const Quaternion& a, const Quaternion& b) {
  const Vector3 u = a.head<3>();
  const Vector3 w = b.head<3>();
  Quaternion result;
  result.head<3>() = a(3) * w + b(3) * u + u.cross(w);
  result(3) = a(3) * b(3) - u.dot(w);
  return result;
}

/// Quaternion of the rotation vector `turn`: exp(turn / 2).
Quaternion quaternion_of(const Vector3& turn) {
  const double half = turn.norm() / 2;
  const double sinc = half > 1e-9 ? std::sin(half) / half : 1.0;
  Quaternion result;
  result.head<3>() = 0.5 * sinc * turn;
  result(3) = std::cos(half);
  return result;
}

/// The shorter rotation vector of a quaternion of unit length, the inverse of `quaternion_of`.
Vector3 turn_of(const Quaternion& rotation) {
  const double q[4] = {rotation(0), rotation(1), rotation(2), rotation(3)};
  double turn[3];
  core::rotation_vector_from_quaternion(q, turn);
  return {turn[0], turn[1], turn[2]};
}

/// Calls `on_run(q, v, count)` for coordinates that correspond one to one to velocities, and
/// `on_quaternion(joint)` for the others.
template <class OnRun, class OnQuaternion>
void visit(const Coordinates& coordinates, OnRun on_run, OnQuaternion on_quaternion) {
  int q = 0;
  int v = 0;
  for (const QuaternionJoint& joint : coordinates.quaternions) {
    on_run(q, v, joint.q - q);
    on_quaternion(joint);
    q = joint.q + (joint.has_position ? 7 : 4);
    v = joint.v + (joint.has_position ? 6 : 3);
  }
  on_run(q, v, coordinates.nq - q);
}

}  // namespace

Coordinates coordinates_of(const Model& model) {
  Coordinates coordinates{model.nq, model.nv, {}};
  for (const auto& body : model.bodies) {
    if (body.kind == interpreter::JointKind::floating) {
      coordinates.quaternions.push_back({body.q, body.v, true});
    } else if (body.kind == interpreter::JointKind::spherical) {
      coordinates.quaternions.push_back({body.q, body.v, false});
    }
  }
  return coordinates;
}

Vector coordinate_rates(const Coordinates& coordinates, const Vector& q, const Vector& qd) {
  Vector rates(coordinates.nq);
  visit(
      coordinates,
      [&](int iq, int iv, int count) { rates.segment(iq, count) = qd.segment(iv, count); },
      [&](const QuaternionJoint& joint) {
        const Vector3 u = q.segment<3>(joint.quaternion());
        const double w = q(joint.quaternion() + 3);
        const Vector3 turn = qd.segment<3>(joint.turn());
        rates.segment<3>(joint.quaternion()) = 0.5 * (w * turn + u.cross(turn));
        rates(joint.quaternion() + 3) = -0.5 * u.dot(turn);
        if (joint.has_position) {
          rates.segment<3>(joint.q) =
              interpreter::rotation_from_quaternion<double>(u, w) * qd.segment<3>(joint.v);
        }
      });
  return rates;
}

void move(const Coordinates& coordinates, const Vector& qd, double dt, Vector& q) {
  visit(
      coordinates,
      [&](int iq, int iv, int count) { q.segment(iq, count) += dt * qd.segment(iv, count); },
      [&](const QuaternionJoint& joint) {
        const Quaternion before = q.segment<4>(joint.quaternion());
        const Vector3 turn = dt * qd.segment<3>(joint.turn());
        if (joint.has_position) {  // in the axes halfway through the rotation
          const Quaternion middle = product(before, quaternion_of(0.5 * turn));
          q.segment<3>(joint.q) +=
              dt * (interpreter::rotation_from_quaternion<double>(middle.head<3>(), middle(3)) *
                    qd.segment<3>(joint.v));
        }
        q.segment<4>(joint.quaternion()) = product(before, quaternion_of(turn));
      });
  normalise_quaternions(coordinates, q);
}

Vector displacement(const Coordinates& coordinates, const Vector& from, const Vector& to) {
  Vector way(coordinates.nv);
  visit(
      coordinates,
      [&](int iq, int iv, int count) {
        way.segment(iv, count) = to.segment(iq, count) - from.segment(iq, count);
      },
      [&](const QuaternionJoint& joint) {
        Quaternion back = from.segment<4>(joint.quaternion());
        back.head<3>() = -back.head<3>();
        const Quaternion now = to.segment<4>(joint.quaternion());
        way.segment<3>(joint.turn()) =
            turn_of(Quaternion(product(back.normalized(), now.normalized())));
        if (joint.has_position) {
          const Vector3 u = now.head<3>();
          way.segment<3>(joint.v) =
              interpreter::rotation_from_quaternion<double>(u, now(3)).transpose() *
              (to.segment<3>(joint.q) - from.segment<3>(joint.q));
        }
      });
  return way;
}

void normalise_quaternions(const Coordinates& coordinates, Vector& q) {
  for (const QuaternionJoint& joint : coordinates.quaternions) {
    q.segment<4>(joint.quaternion()).normalize();
  }
}

double kinetic_energy(const Model& model, const State& state) {
  return 0.5 * state.qd.dot(interpreter::mass_matrix<double>(model, state.q) * state.qd);
}

double mechanical_energy(const Model& model, const State& state) {
  const auto k = interpreter::kinematics<double>(model, state.q, state.qd);
  double energy = kinetic_energy(model, state);
  for (int i = 0; i < model.size(); ++i) {
    const Vector3 com = k.p_world[i] + k.R_world[i] * model.body(i).com;
    energy -= model.body(i).mass * model.gravity.dot(com);
  }
  return energy + interpreter::spring_energy<double>(model, state.q);
}

interpreter::Vector6<double> momentum(const Model& model, const State& state) {
  const auto k = interpreter::kinematics<double>(model, state.q, state.qd);
  interpreter::Vector6<double> total = interpreter::Vector6<double>::Zero();
  for (int i = 0; i < model.size(); ++i) {
    const auto& b = model.body(i);
    const Vector3 v = interpreter::linear(k.v[i]);
    const Vector3 w = interpreter::angular(k.v[i]);
    const Vector3 P = k.R_world[i] * (b.mass * (v + w.cross(b.com)));
    const Vector3 L = k.R_world[i] * (b.mass * b.com.cross(v) + b.inertia * w);
    total += interpreter::stack<double>(P, L + k.p_world[i].cross(P));
  }
  return total;
}

}  // namespace treeline::simulation
