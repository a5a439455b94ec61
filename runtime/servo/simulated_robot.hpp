#pragma once

#include "servo/integrate.hpp"
#include "servo/robot_proxy.hpp"

namespace treeline::servo {

/// A robot that is simulated by its forward dynamics. Torques are constant between writes
/// (zero-order hold). Each call of `pass_time` integrates in `substeps` steps.
template <SimulatedFunctions F>
class SimulatedRobot {
 public:
  using Floating = FloatingJoints<F::kCoordinates, F::kVelocities>;

  explicit SimulatedRobot(const StateOf<F>& initial, int substeps = 4,
                          const Floating& floating = {}) noexcept
      : state_(initial), substeps_(substeps), floating_(floating) {}

  bool connected() const noexcept { return connected_; }
  void read(StateOf<F>& state) const noexcept { state = state_; }
  void write(const double (&tau)[F::kVelocities]) noexcept {
    for (int i = 0; i < F::kVelocities; ++i) {
      tau_[i] = tau[i];
    }
  }
  void pass_time(double seconds) noexcept {
    for (int step = 0; step < substeps_; ++step) {
      integrate_runge_kutta<F>(floating_, tau_, seconds / substeps_, state_);
    }
  }

  /// Disconnects the robot, for tests of the loop.
  void disconnect() noexcept { connected_ = false; }
  /// Sets the state, as a disturbance would.
  void set_state(const StateOf<F>& state) noexcept { state_ = state; }

 private:
  StateOf<F> state_;
  double tau_[F::kVelocities] = {};
  int substeps_;
  Floating floating_;
  bool connected_ = true;
};

}  // namespace treeline::servo
