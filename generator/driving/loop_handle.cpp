#include "driving/loop_handle.hpp"

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
  for (const drive::DrivenObstacle& obstacle : robot.obstacles) {
    obstacles.push_back(obstacle.shape);
  }
}

drive::LoopOptions options_for(const drive::RobotDescription& robot, const LoopNumbers& numbers,
                               const std::vector<double>& start) {
  constexpr double kPullPerMass = 10;   // 1/s^2: stiffness of a pull by mass
  constexpr double kHardestPull = 2.5;  // m/s^2: the most that a pull exerts, by mass
  // A machine that simulates beside a browser is late at times.
  constexpr int kOverruns = 100;
  constexpr double kLongestDelay = 0.1;  // s
  drive::LoopOptions options;
  options.overruns_in_a_row = kOverruns;
  options.longest_delay = kLongestDelay;
  options.start = start.data();
  options.lower = numbers.lower.data();
  options.upper = numbers.upper.data();
  options.velocity = numbers.velocity.data();
  options.torque = numbers.torque.data();
  options.pull_stiffness = kPullPerMass * robot.mass;
  options.pull_force = kHardestPull * robot.mass;
  options.surroundings.obstacles = numbers.obstacles.data();
  options.surroundings.obstacle_count = static_cast<int>(numbers.obstacles.size());
  options.surroundings.guarded = robot.guarded.data();
  options.surroundings.guarded_count = static_cast<int>(robot.guarded.size());
  options.surroundings.repulsion = robot.repulsion;
  return options;
}

LoopHandle::LoopHandle(const drive::RobotLibrary& library, const drive::RobotDescription& robot,
                       const LoopSetup& setup)
    : library_(library), loop_(nullptr, Destroyer{library.destroy}) {
  const LoopNumbers numbers(robot);
  drive::LoopOptions options = options_for(robot, numbers, setup.start);
  options.home = setup.home.empty() ? nullptr : setup.home.data();
  options.rate = setup.rate;
  options.real_time = setup.real_time;
  options.robot = setup.external;
  // A robot elsewhere has braked by itself after so long.
  if (setup.external.connected != nullptr) options.longest_delay = 0.05;
  options.simulation = setup.simulation;
  options.reference = setup.reference;
  loop_.reset(library.create(&options));
}

namespace {

/// So near to a limit tasks push a joint away, see `DriveController`; rad or m.
double from_limit(double range) {
  return std::min(0.08, 0.1 * range);
}

}  // namespace

std::vector<double> default_start(const drive::RobotDescription& robot) {
  std::vector<double> start;
  for (const DrivenCoordinate& coordinate : robot.coordinates) {
    const double range = coordinate.upper - coordinate.lower;
    const double margin = std::isfinite(range) ? std::max(0.05 * range, from_limit(range)) : 0.0;
    start.push_back(coordinate.measure == drive::Measure::qw
                        ? 1.0
                        : std::clamp(0.0, coordinate.lower + margin, coordinate.upper - margin));
  }
  return start;
}

}  // namespace treeline
