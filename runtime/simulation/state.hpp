#pragma once

#include <vector>

#include "interpreter/model.hpp"

/// Simulation of any robot on a host computer: run-time sizes, heap, exceptions of the standard
/// library. SI units; coordinates as everywhere (quaternions x y z w).
namespace treeline::simulation {

using Vector = interpreter::Vector<double>;
using Vector3 = interpreter::Vector3<double>;
using Matrix3 = interpreter::Matrix3<double>;
using Model = interpreter::Model<double>;

/// Coordinates and velocities.
struct State {
  Vector q, qd;
};

/// Where a joint with a quaternion has its coordinates.
struct QuaternionJoint {
  int q = 0;                 ///< first of its 7 coordinates, or of 4 for a ball joint
  int v = 0;                 ///< first of its 6 velocities, or of 3
  bool has_position = true;  ///< floating; else a ball joint
  [[nodiscard]] int quaternion() const { return has_position ? q + 3 : q; }
  [[nodiscard]] int turn() const { return has_position ? v + 3 : v; }
};

/// How coordinates follow velocities: one to one but for joints with a quaternion, ascending.
struct Coordinates {
  int nq = 0, nv = 0;
  std::vector<QuaternionJoint> quaternions;
};

Coordinates coordinates_of(const Model& model);

/// dq/dt.
Vector coordinate_rates(const Coordinates& coordinates, const Vector& q, const Vector& qd);

/// Moves for `dt` seconds with the body twists and rates `qd` as they are: turns by exp(w dt), so
/// that quaternions stay unit.
void move(const Coordinates& coordinates, const Vector& qd, double dt, Vector& q);

/// Restores unit length, which steps that add rates leave to their order.
void normalise_quaternions(const Coordinates& coordinates, Vector& q);

/// Kinetic energy, J.
double kinetic_energy(const Model& model, const State& state);
/// Kinetic and potential energy, J; the latter zero with the centre of mass at the world's origin.
double mechanical_energy(const Model& model, const State& state);
/// [momentum; angular momentum about the world's origin], world axes.
interpreter::Vector6<double> momentum(const Model& model, const State& state);

}  // namespace treeline::simulation
