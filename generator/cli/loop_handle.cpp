#include "cli/loop_handle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace treeline {

using drive::DrivenCoordinate;

LoopNumbers::LoopNumbers(const drive::RobotDescription& robot)
    : velocity(static_cast<std::size_t>(robot.velocities), std::numeric_limits<double>::infinity()),
      torque(velocity) {
  for (const DrivenCoordinate& coordinate : robot.coordinates) {
    lower.push_back(coordinate.lower);
    upper.push_back(coordinate.upper);
    if (!drive::is_single(coordinate)) continue;
    const auto v = static_cast<std::size_t>(coordinate.velocity_index);
    velocity[v] = coordinate.velocity;
    torque[v] = coordinate.effort;
  }
}

drive::LoopOptions options_for(const drive::RobotDescription& robot, const LoopNumbers& numbers,
                               const std::vector<double>& start) {
  constexpr double kPullPerMass = 10;   // 1/s^2: stiffness of a pull by mass
  constexpr double kHardestPull = 2.5;  // m/s^2: the most that a pull exerts, by mass
  constexpr int kOverruns = 100;  // a machine that simulates beside a browser is late at times
  drive::LoopOptions options;
  options.overruns_in_a_row = kOverruns;
  options.start = start.data();
  options.lower = numbers.lower.data();
  options.upper = numbers.upper.data();
  options.velocity = numbers.velocity.data();
  options.torque = numbers.torque.data();
  options.pull_stiffness = kPullPerMass * robot.mass;
  options.pull_force = kHardestPull * robot.mass;
  return options;
}

LoopHandle::LoopHandle(const drive::RobotLibrary& library, const drive::RobotDescription& robot,
                       double rate, bool real_time, const std::vector<double>& start,
                       const drive::ExternalRobot& external)
    : library_(library), loop_(nullptr, Destroyer{library.destroy}) {
  const LoopNumbers numbers(robot);
  drive::LoopOptions options = options_for(robot, numbers, start);
  options.rate = rate;
  options.real_time = real_time;
  options.robot = external;
  loop_.reset(library.create(&options));
}

std::vector<double> default_start(const drive::RobotDescription& robot) {
  std::vector<double> start;
  for (const DrivenCoordinate& coordinate : robot.coordinates) {
    const double range = coordinate.upper - coordinate.lower;
    const double margin = std::isfinite(range) ? 0.05 * range : 0.0;
    start.push_back(coordinate.measure == drive::Measure::qw
                        ? 1.0
                        : std::clamp(0.0, coordinate.lower + margin, coordinate.upper - margin));
  }
  return start;
}

}  // namespace treeline
