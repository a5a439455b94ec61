#include "precise_loops.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <string>

#include "drift.hpp"
#include "plane_loop.hpp"
#include "space_loop.hpp"

namespace treeline::stress {
namespace {

constexpr double kStep = 2e-4;  ///< s
constexpr double kSpeed = 5;    ///< of the first joint where it begins, rad/s

struct Plane {
  static constexpr int kJoints = plane_loop::kVelocities;
  static constexpr int kRows = 2;
  static constexpr std::array<double, kJoints> kNear = {0.3, -0.6, 0.2};  ///< a closed pose
  static constexpr auto& forward_dynamics = plane_loop::constrained_forward_dynamics;
  static constexpr auto& errors = plane_loop::constraint_errors;
  static constexpr auto& jacobian = plane_loop::constraint_jacobian;
  static constexpr auto& kinetic_energy = plane_loop::kinetic_energy;
  static constexpr auto& potential_energy = plane_loop::potential_energy;
};

struct Space {
  static constexpr int kJoints = space_loop::kVelocities;
  static constexpr int kRows = 3;
  static constexpr std::array<double, kJoints> kNear = {0.2, 0.1, -0.5, 0.3};
  static constexpr auto& forward_dynamics = space_loop::constrained_forward_dynamics;
  static constexpr auto& errors = space_loop::constraint_errors;
  static constexpr auto& jacobian = space_loop::constraint_jacobian;
  static constexpr auto& kinetic_energy = space_loop::kinetic_energy;
  static constexpr auto& potential_energy = space_loop::potential_energy;
};

/// How a loop is kept closed: by gains on its errors, 1/s and 1/s^2, or by going to the nearest
/// closed pose and the nearest permitted velocity after each step.
struct Keeping {
  double damping = 0, stiffness = 0;
  bool projected = false;
};

/// A loop that turns under gravity by generated code.
template <class Loop>
class TurningLoop {
 public:
  explicit TurningLoop(const Keeping& keeping) : keeping_(keeping) {
    std::copy(Loop::kNear.begin(), Loop::kNear.end(), q_);
    v_[0] = kSpeed;
    close();
  }

  /// Adds the step's change with what adding the changes before has lost (Kahan 1965).
  void step() {
    State change{};
    stepper_.do_step([this](const State& at, State& rate, double) { rates(at, rate); }, change, 0.0,
                     kStep);
    for (std::size_t i = 0; i < 2 * n; ++i) {
      double& x = i < n ? q_[i] : v_[i - n];
      const double before = x;
      x += lost_[i] + change[i];
      lost_[i] += change[i] - (x - before);
    }
    // Within half a turn of zero angles keep their last digits, however long the loop turns.
    constexpr double kTurn = 6.283185307179586;
    for (double& angle : q_) angle -= kTurn * std::round(angle / kTurn);
    if (keeping_.projected) close();
  }

  [[nodiscard]] double kinetic_energy() const {
    double energy[1];
    Loop::kinetic_energy(q_, v_, energy);
    return energy[0];
  }
  [[nodiscard]] double energy() const {
    double potential[1];
    Loop::potential_energy(q_, potential);
    return kinetic_energy() + potential[0];
  }
  /// m
  [[nodiscard]] double opening() const {
    double errors[m];
    Loop::errors(q_, errors);
    return Rows::Map(errors).cwiseAbs().maxCoeff();
  }

 private:
  static constexpr std::size_t n = Loop::kJoints, m = Loop::kRows;
  using State = std::array<double, 2 * n>;
  using Rows = Eigen::Matrix<double, Loop::kRows, 1>;
  using Joints = Eigen::Matrix<double, Loop::kJoints, 1>;
  using Jacobian = Eigen::Matrix<double, Loop::kRows, Loop::kJoints, Eigen::RowMajor>;

  /// `at`: the change since the step began.
  void rates(const State& at, State& rate) const {
    double q[n], v[n], tau[n] = {}, qdd[n], f[m];
    for (std::size_t i = 0; i < n; ++i) {
      q[i] = q_[i] + (lost_[i] + at[i]);
      v[i] = v_[i] + (lost_[n + i] + at[n + i]);
    }
    const double gains[2] = {keeping_.damping, keeping_.stiffness};
    Loop::forward_dynamics(q, v, tau, gains, qdd, f);
    std::copy_n(v, n, rate.begin());
    std::copy_n(qdd, n, rate.begin() + n);
  }

  /// The least change of joints that changes rows so.
  Joints least_change(const Rows& rows) const {
    double J[m * n];
    Loop::jacobian(q_, J);
    return Jacobian::Map(J).completeOrthogonalDecomposition().solve(rows);
  }

  void close() {
    for (int i = 0; i < 20 && opening() > 2e-16; ++i) {
      double errors[m];
      Loop::errors(q_, errors);
      Joints::Map(q_) -= least_change(Rows::Map(errors));
    }
    double J[m * n];
    Loop::jacobian(q_, J);
    Joints::Map(v_) -= least_change(Jacobian::Map(J) * Joints::Map(v_));
  }

  Keeping keeping_;
  double q_[n] = {}, v_[n] = {};
  State lost_{};
  boost::numeric::odeint::runge_kutta_fehlberg78<State> stepper_;
};

template <class Loop>
void turn(const std::string& name, const Keeping& keeping, int steps, Finding& finding) {
  TurningLoop<Loop> loop(keeping);
  const double start = loop.energy();
  double largest = 0, change = 0;
  const Drift drift = run(
      steps, [&](int) { loop.step(); },
      [&] {
        largest = std::max(largest, loop.kinetic_energy());
        change = std::max(change, std::abs(loop.energy() - start));
        return loop.opening();
      });
  const double opening = *std::max_element(drift.y.begin(), drift.y.end());
  const double energy = std::log10(change / largest);
  finding.x = drift.at;
  finding.curves.push_back({"how far the loop opens", name, drift.y, false});
  finding.said.push_back(fmt::format("log10 after {} steps, {}: loop {:.1f}, energy {:.1f}", steps,
                                     name, opening, energy));
  claim(opening < -12, fmt::format("{}: closed to 1e-12 m", name), finding);
  claim(energy < -12, fmt::format("{}: energy kept to 1e-12", name), finding);
}

}  // namespace

Finding precise_loops(const Effort& effort) {
  const int steps = effort.quick ? 20000 : 1000000;
  Finding finding{"precise_loops",
                  "Loops turn by generated code: steps of 0.2 ms, Runge-Kutta of eighth order",
                  "log10 of the number of steps",
                  "log10 of m",
                  {},
                  {},
                  {},
                  {}};
  const Keeping stabilised{40, 400, false}, projected{0, 0, true};
  turn<Plane>("plane, stabilised", stabilised, steps, finding);
  turn<Plane>("plane, projected", projected, steps, finding);
  turn<Space>("space, stabilised", stabilised, steps, finding);
  turn<Space>("space, projected", projected, steps, finding);
  return finding;
}

}  // namespace treeline::stress
