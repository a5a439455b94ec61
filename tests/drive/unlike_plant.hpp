#pragma once
// Robots that are not as their model says.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "cli/loop_handle.hpp"
#include "launch/launch.hpp"

namespace treeline::test {

/// Makes every second link a tenth heavier and the others a tenth lighter.
inline void change_masses(Robot& robot) {
  double factor = 1.1;
  for (Link& link : robot.links) {
    if (!link.inertial) continue;
    Inertial& of = *link.inertial;
    for (double* each : {&of.mass, &of.ixx, &of.ixy, &of.ixz, &of.iyy, &of.iyz, &of.izz}) {
      *each *= factor;
    }
    factor = 2 - factor;
  }
}

/// Friction of each joint, N m or N: 2 % of its motor's torque, but no more than slows it down by 3
/// rad/s^2 or m/s^2 at `start`. More than that would be of rotors that the model does not have.
inline std::vector<double> friction_of(const LaunchedRobot& robot,
                                       const std::vector<double>& start) {
  constexpr double kShare = 0.02;
  constexpr double kDeceleration = 3;
  constexpr double kMoment = 1e-4;  // s
  const drive::RobotLibrary& library = robot.library.functions();
  const auto size = static_cast<std::size_t>(library.velocities);
  const LoopNumbers numbers(robot.description);
  const drive::LoopOptions options = options_for(robot.description, numbers, start);
  const auto speed_after = [&](std::size_t joint, double torque) {
    std::vector<double> tau(size, 0.0), state(start.size() + size);
    tau[joint] = torque;
    const std::unique_ptr<void, void (*)(void*)> alone(library.create_robot(&options),
                                                       library.destroy_robot);
    library.advance_robot(alone.get(), tau.data(), kMoment);
    library.read_robot(alone.get(), state.data());
    return state[start.size() + joint];
  };
  std::vector<double> friction(size, 0.0);
  for (const drive::DrivenCoordinate& joint : robot.description.coordinates) {
    if (!is_single(joint) || !std::isfinite(joint.effort)) continue;
    const auto i = static_cast<std::size_t>(joint.velocity_index);
    const double gained = speed_after(i, 1e-3) - speed_after(i, 0);
    if (!(gained > 0)) continue;
    const double inertia = kMoment * 1e-3 / gained;
    friction[i] = std::fmin(kShare * joint.effort, kDeceleration * inertia);
  }
  return friction;
}

/// A robot beside the loop that drives it: of other masses, with dry friction and as much again at
/// the limit of speed, encoders of 16 bits a turn, and torques that come late by some cycles.
class UnlikePlant {
 public:
  UnlikePlant(const LaunchedRobot& robot, const std::vector<double>& start,
              const std::vector<double>& friction, int delay)
      : library_(robot.library.functions()),
        state_(static_cast<std::size_t>(library_.coordinates + library_.velocities)),
        viscous_(friction.size(), 0.0),
        quantum_(friction.size(), 0.0) {
    constexpr double kCount = 2 * M_PI / 65536;  // rad or m
    for (const drive::DrivenCoordinate& joint : robot.description.coordinates) {
      if (!is_single(joint)) continue;
      const auto i = static_cast<std::size_t>(joint.velocity_index);
      quantum_[i] = kCount;
      if (std::isfinite(joint.velocity)) viscous_[i] = friction[i] / joint.velocity;
    }
    const LoopNumbers numbers(robot.description);
    drive::LoopOptions options = options_for(robot.description, numbers, start);
    options.simulation.coulomb = friction.data();
    options.simulation.viscous = viscous_.data();
    options.simulation.quantum = quantum_.data();
    options.simulation.delay = delay;
    robot_ = {library_.create_robot(&options), library_.destroy_robot};
  }

  /// For a loop; valid while this object is there.
  drive::ExternalRobot link() {
    return {this, [](void*) { return true; },
            [](void* self, double* q, double* qd) { static_cast<UnlikePlant*>(self)->read(q, qd); },
            [](void* self, const double* tau) { static_cast<UnlikePlant*>(self)->move(tau); }};
  }

 private:
  void read(double* q, double* qd) {
    library_.read_robot(robot_.get(), state_.data());
    std::copy_n(state_.data(), library_.coordinates, q);
    std::copy_n(state_.data() + library_.coordinates, library_.velocities, qd);
  }
  void move(const double* tau) {
    constexpr double kPeriod = 1e-3;  // s
    library_.advance_robot(robot_.get(), tau, kPeriod);
  }

  const drive::RobotLibrary& library_;
  std::vector<double> state_, viscous_, quantum_;
  std::unique_ptr<void, void (*)(void*)> robot_{nullptr, nullptr};
};

}  // namespace treeline::test
