#pragma once

#include <vector>

#include "interpreter/model.hpp"

/// Simulation of any robot on a host computer, with sizes known at run time, heap memory, and
/// exceptions of the standard library. SI units; quaternions are x y z w.
namespace treeline::simulation {

using Vector = interpreter::Vector<double>;
using Vector3 = interpreter::Vector3<double>;
using Matrix3 = interpreter::Matrix3<double>;
using Model = interpreter::Model<double>;

/// What flights without contact did to the energy of a robot, J.
struct FlightAccount {
  double change = 0;  ///< of the energy
  double work = 0;    ///< of joint forces and friction; the rest of the change is an error
};

/// Coordinates and velocities.
struct State {
  Vector q, qd;
  FlightAccount flown = {};  ///< of all flights that led here, if flights count it
};

/// Place of the coordinates of a joint with a quaternion.
struct QuaternionJoint {
  int q = 0;                 ///< first of 7 coordinates, or of 4 for a ball joint
  int v = 0;                 ///< first of 6 velocities, or of 3 for a ball joint
  bool has_position = true;  ///< floating joint; false: ball joint
  [[nodiscard]] int quaternion() const { return has_position ? q + 3 : q; }
  [[nodiscard]] int turn() const { return has_position ? v + 3 : v; }
};

/// Correspondence of coordinates and velocities: one to one, except for the joints with a
/// quaternion, which are listed in ascending order.
struct Coordinates {
  int nq = 0, nv = 0;
  std::vector<QuaternionJoint> quaternions;
};

Coordinates coordinates_of(const Model& model);

/// dq/dt.
Vector coordinate_rates(const Coordinates& coordinates, const Vector& q, const Vector& qd);

/// Moves the coordinates for `dt` seconds with constant body twists and rates `qd`. Rotations are
/// exp(w dt), so quaternions keep unit length.
void move(const Coordinates& coordinates, const Vector& qd, double dt, Vector& q);

/// How far coordinates are from others, by velocity: differences; of a quaternion the rotation
/// vector that leads from one to the other, of a floating joint the way in its child's axes.
Vector displacement(const Coordinates& coordinates, const Vector& from, const Vector& to);

/// Restores unit length of the quaternions, which steps that add rates preserve only to their
/// order.
void normalise_quaternions(const Coordinates& coordinates, Vector& q);

/// Kinetic energy, J.
double kinetic_energy(const Model& model, const State& state);
/// Kinetic plus potential energy, J. The potential energy is zero if the centre of mass is at the
/// world's origin.
double mechanical_energy(const Model& model, const State& state);
/// [momentum; angular momentum about the world's origin], world axes.
interpreter::Vector6<double> momentum(const Model& model, const State& state);

}  // namespace treeline::simulation
