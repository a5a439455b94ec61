#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace treeline::tests {

/// How a simulated robot differs from the one that its controller knows.
struct Imperfection {
  double mass_scale = 1;  ///< of every link
  double payload = 0;     ///< kg, at `payload_reach` m along z of the tool
  double payload_reach = 0.05;
  double friction = 0;  ///< Coulomb, as a share of each torque limit
  int delay = 0;        ///< steps between the controller and the motors
  double encoder = 0;   ///< rad or m, of a count; velocities are differences
  bool blind = false;   ///< to velocities, which the controller observes
};

/// An emitted controller with the robot that it drives, of which a payload is an argument of
/// `forward_dynamics`. Symplectic Euler, four steps a period.
template <class Controller, auto ForwardDynamics>
class Plant {
 public:
  using Emitted = Controller;
  static constexpr double kPeriod = 1e-3;  // s
  static constexpr int n = Controller::kJoints;
  using Vector = std::array<double, static_cast<std::size_t>(n)>;

  explicit Plant(const Imperfection& imperfection, const Vector& start)
      : q(start), is_(imperfection) {
    Controller::default_config(config);
    const double reach = is_.payload_reach;
    payload_[0] = is_.payload;
    payload_[3] = is_.payload * reach;
    const double thickness = 0.4 * is_.payload * 0.04 * 0.04;  // a ball of 4 cm
    payload_[4] = payload_[6] = is_.payload * reach * reach + thickness;
    payload_[9] = thickness;
    for (int i = 0; i < n; ++i) torque_[static_cast<std::size_t>(i)] = config.torque[i];
    if constexpr (requires { config.observer; }) {
      if (is_.blind) config.observer = 300;
    }
    late_.assign(static_cast<std::size_t>(is_.delay), Vector{});
  }

  void send(int kind) {
    input.command.kind = kind;
    ++input.command.sequence;
  }

  /// One period. The controller sees what `spoil` leaves of the measurement.
  template <class Spoil>
  void step(Spoil&& spoil) {
    for (int i = 0; i < n; ++i) measure(i);
    measured_ = true;
    spoil(input);
    Controller::step(config, state, input, output);
    move();
  }
  void step() {
    step([](auto&) {});
  }
  void run(double seconds) {
    for (int k = 0; k < static_cast<int>(std::lround(seconds / kPeriod)); ++k) step();
  }

  double fastest() const {
    double most = 0;
    for (const double each : qd) most = std::max(most, std::fabs(each));
    return most;
  }

  typename Controller::Config config{};
  typename Controller::State state{};
  typename Controller::Input input{};
  typename Controller::Output output{};
  Vector q{}, qd{};

 private:
  /// Encoders count, and their velocities are filtered differences over five periods or so.
  void measure(int i) {
    measure_motion(i);
    if (is_.blind) input.qd[i] = std::numeric_limits<double>::quiet_NaN();
  }
  void measure_motion(int i) {
    const auto at = static_cast<std::size_t>(i);
    if (!(is_.encoder > 0)) {
      input.q[i] = q[at];
      input.qd[i] = qd[at];
      return;
    }
    const double counted = is_.encoder * std::round(q[at] / is_.encoder);
    const double rate = measured_ ? (counted - last_[at]) / kPeriod : 0;
    filtered_[at] += 0.2 * (rate - filtered_[at]);
    last_[at] = counted;
    input.q[i] = counted;
    input.qd[i] = filtered_[at];
  }

  void move() {
    Vector tau;
    for (int i = 0; i < n; ++i) tau[static_cast<std::size_t>(i)] = output.tau[i];
    late_.push_back(tau);
    tau = late_.front();
    late_.erase(late_.begin());
    const Vector yielding = is_.friction > 0 ? inverse_masses() : Vector{};
    constexpr int kParts = 4;
    const double h = kPeriod / kParts;
    for (int part = 0; part < kParts; ++part) {
      const Vector qdd = accelerations(tau);
      for (std::size_t i = 0; i < qdd.size(); ++i) {
        // Dry friction takes away what speed it can, and no more: it never pushes.
        const double free = qd[i] + h * qdd[i];
        const double rubbed = h * is_.friction * torque_[i] * yielding[i];
        qd[i] = std::copysign(std::max(0.0, std::fabs(free) - rubbed), free);
        q[i] += h * qd[i];
      }
    }
  }

  Vector accelerations(const Vector& tau) const {
    double pushed[n], qdd[n], angles[n], rates[n];
    for (int i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      pushed[i] = tau[at] / is_.mass_scale;
      angles[i] = q[at];
      rates[i] = qd[at];
    }
    ForwardDynamics(angles, rates, pushed, payload_, qdd);
    Vector result;
    std::copy(qdd, qdd + n, result.begin());
    return result;
  }

  /// The diagonal of M^-1.
  Vector inverse_masses() const {
    const Vector still = accelerations({});
    Vector diagonal{};
    for (std::size_t i = 0; i < diagonal.size(); ++i) {
      Vector unit{};
      unit[i] = 1;
      diagonal[i] = accelerations(unit)[i] - still[i];
    }
    return diagonal;
  }

  Imperfection is_;
  double payload_[10] = {};
  std::vector<Vector> late_;
  Vector last_{}, filtered_{}, torque_{};
  bool measured_ = false;
};

}  // namespace treeline::tests
