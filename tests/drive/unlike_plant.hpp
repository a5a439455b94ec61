#pragma once
// Robots that are not as their model says.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "driving/loop_handle.hpp"
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

/// Drives that the model does not have, as lists by velocities.
class UnlikeDrives {
 public:
  /// `robot` has other masses, and no rotors: those of the model, by joint, are in gears with play.
  UnlikeDrives(const LaunchedRobot& robot, const std::vector<double>& start,
               const std::map<std::string, double>& rotors)
      : friction_(static_cast<std::size_t>(robot.description.velocities), 0.0),
        viscous_(friction_),
        quantum_(friction_),
        play_(friction_),
        rotor_(friction_),
        stiffness_(friction_) {
    for (const drive::DrivenCoordinate& joint : robot.description.coordinates) {
      if (!is_single(joint)) continue;
      const auto i = static_cast<std::size_t>(joint.velocity_index);
      quantum_[i] = kCount;
      if (const auto rotor = rotors.find(joint.name); rotor != rotors.end()) {
        play_[i] = kPlay;
        rotor_[i] = rotor->second;
        stiffness_[i] = kSwing * kSwing * rotor_[i];
      }
      if (!std::isfinite(joint.effort)) continue;
      const double inertia = rotor_[i] + inertia_of(robot, start, i);
      friction_[i] = std::fmin(kShare * joint.effort, kDeceleration * inertia);
      if (std::isfinite(joint.velocity)) viscous_[i] = friction_[i] / joint.velocity;
    }
  }

  /// The result points into this object.
  drive::SimulationOptions options(int delay) const {
    drive::SimulationOptions options;
    options.coulomb = friction_.data();
    options.viscous = viscous_.data();
    options.quantum = quantum_.data();
    options.play = play_.data();
    options.rotor = rotor_.data();
    options.gear_stiffness = stiffness_.data();
    options.delay = delay;
    return options;
  }

 private:
  static constexpr double kCount = 2 * M_PI / 65536;  ///< rad or m: encoders of 16 bits a turn
  static constexpr double kPlay = 5e-4;               ///< rad or m
  static constexpr double kSwing = 100;               ///< rad/s, of a rotor on its teeth
  static constexpr double kShare = 0.02;              ///< of the motor's torque: dry friction
  /// rad/s^2 or m/s^2 by which dry friction slows a joint down at most: more would be of rotors
  /// that the model does not have.
  static constexpr double kDeceleration = 3;

  /// What a joint's motor moves at `start` if the others are free, kg m^2 or kg; 0: nothing.
  static double inertia_of(const LaunchedRobot& robot, const std::vector<double>& start,
                           std::size_t joint) {
    constexpr double kMoment = 1e-4;  // s
    constexpr double kTorque = 1e-3;  // N m or N
    const drive::RobotLibrary& library = robot.library.functions();
    const LoopNumbers numbers(robot.description);
    const drive::LoopOptions options = options_for(robot.description, numbers, start);
    const auto speed_after = [&](double torque) {
      const auto size = static_cast<std::size_t>(library.velocities);
      std::vector<double> tau(size, 0.0), state(start.size() + size);
      tau[joint] = torque;
      const std::unique_ptr<void, void (*)(void*)> alone(library.create_robot(&options),
                                                         library.destroy_robot);
      library.advance_robot(alone.get(), tau.data(), kMoment);
      library.read_robot(alone.get(), state.data());
      return state[start.size() + joint];
    };
    const double gained = speed_after(kTorque) - speed_after(0);
    return gained > 0 ? kMoment * kTorque / gained : 0.0;
  }

  std::vector<double> friction_, viscous_, quantum_, play_, rotor_, stiffness_;
};

/// A robot beside the loop that drives it.
class UnlikePlant {
 public:
  UnlikePlant(const LaunchedRobot& robot, const std::vector<double>& start,
              const drive::SimulationOptions& simulation)
      : library_(robot.library.functions()),
        state_(static_cast<std::size_t>(library_.coordinates + library_.velocities)) {
    const LoopNumbers numbers(robot.description);
    drive::LoopOptions options = options_for(robot.description, numbers, start);
    options.simulation = simulation;
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
  std::vector<double> state_;
  std::unique_ptr<void, void (*)(void*)> robot_{nullptr, nullptr};
};

}  // namespace treeline::test
