#pragma once

namespace treeline::experiments {

/// Gains of Baumgarte's stabilisation, which closes the drift of the grasps: critically damped,
/// with rates of 50 /s.
inline constexpr double kStabilisation[2] = {100.0, 2500.0};

/// Generated functions about one object in several hands, in the form that the servo library
/// expects of a robot. Its dynamics are those of the closed chain with stabilisation; the torque
/// that holds it at rest also holds the object.
template <class G, int kHands = 2>
struct RobotWithObject : G {
  using G::kCoordinates;
  using G::kVelocities;
  static constexpr int kDrift = 6 * (kHands - 1);
  static constexpr int kInternal = 6 * (kHands - 1);

  static void inverse_dynamics(const double (&q)[kCoordinates], const double (&qd)[kVelocities],
                               const double (&qdd)[kVelocities],
                               double (&tau)[kVelocities]) noexcept {
    const double rest[6] = {};
    const double none[kInternal] = {};
    G::object_control_torque(q, qd, qdd, rest, none, tau);
  }
  static void forward_dynamics(const double (&q)[kCoordinates], const double (&qd)[kVelocities],
                               const double (&tau)[kVelocities],
                               double (&qdd)[kVelocities]) noexcept {
    double xdd[6];
    double f_grasp[6 * kHands];
    double internal[kInternal];
    G::object_forward_dynamics(q, qd, tau, kStabilisation, qdd, xdd, f_grasp, internal);
  }
  static void drift(const double (&q)[kCoordinates], double (&e)[kDrift]) noexcept {
    const double qd[kVelocities] = {};
    double position[3];
    double rotation[9];
    double velocity[6];
    double rate[kDrift];
    G::object_state(q, qd, position, rotation, velocity, e, rate);
  }
};

}  // namespace treeline::experiments
