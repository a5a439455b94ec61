#pragma once

#include <concepts>

namespace treeline::servo {

/// Positions and velocities of a robot, in the order and units of its generated code.
template <int nq, int nv>
struct RobotState {
  double q[nq] = {};
  double qd[nv] = {};
};

/// The functions of a robot that the servo library calls: a struct whose static members are the
/// generated functions and the sizes nq and nv, for instance
///
///     struct Puma {
///       static constexpr int kCoordinates = puma560::kCoordinates;
///       static constexpr int kVelocities = puma560::kVelocities;
///       static constexpr auto& inverse_dynamics = puma560::inverse_dynamics;
///       static constexpr auto& forward_dynamics = puma560::forward_dynamics;
///     };
template <class F>
concept RobotFunctions = requires(const double (&q)[F::kCoordinates],
                                  const double (&qd)[F::kVelocities],
                                  const double (&input)[F::kVelocities],
                                  double (&output)[F::kVelocities]) {
  F::inverse_dynamics(q, qd, input, output);
};

template <class F>
concept SimulatedFunctions = requires(const double (&q)[F::kCoordinates],
                                      const double (&qd)[F::kVelocities],
                                      const double (&tau)[F::kVelocities],
                                      double (&qdd)[F::kVelocities]) {
  F::forward_dynamics(q, qd, tau, qdd);
};

template <class F>
using StateOf = RobotState<F::kCoordinates, F::kVelocities>;

/// Interface to a simulated or a real robot (Chang fig. 9.1). `pass_time` is called once per cycle
/// with the time (s) until the next one begins. A simulation advances by this time; a real robot
/// has nothing to do.
template <class P, class F>
concept RobotProxy = requires(P& proxy, StateOf<F>& state, const double (&tau)[F::kVelocities]) {
  { proxy.connected() } -> std::same_as<bool>;
  proxy.read(state);
  proxy.write(tau);
  proxy.pass_time(0.001);
};

}  // namespace treeline::servo
