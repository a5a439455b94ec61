#include "cli/loop_handle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace treeline {

using drive::DrivenCoordinate;

LoopHandle::LoopHandle(const drive::RobotLibrary& library, const drive::RobotDescription& robot,
                       double rate, bool real_time, const std::vector<double>& start,
                       const drive::ExternalRobot& external)
    : library_(library), loop_(nullptr, Destroyer{library.destroy}) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  constexpr double kPullPerMass = 40;  // 1/s^2: stiffness of a pull by mass
  constexpr double kGravity = 9.81;
  constexpr int kOverruns = 100;  // a machine that simulates beside a browser is late at times
  std::vector<double> lower, upper;
  std::vector<double> velocity(static_cast<std::size_t>(robot.velocities), kNone);
  std::vector<double> torque = velocity;
  for (const DrivenCoordinate& coordinate : robot.coordinates) {
    lower.push_back(coordinate.lower);
    upper.push_back(coordinate.upper);
    if (!drive::is_single(coordinate)) continue;
    const auto v = static_cast<std::size_t>(coordinate.velocity_index);
    velocity[v] = coordinate.velocity;
    torque[v] = coordinate.effort;
  }
  drive::LoopOptions options;
  options.rate = rate;
  options.real_time = real_time;
  options.overruns_in_a_row = kOverruns;
  options.start = start.data();
  options.lower = lower.data();
  options.upper = upper.data();
  options.velocity = velocity.data();
  options.torque = torque.data();
  options.pull_stiffness = kPullPerMass * robot.mass;
  options.pull_force = kGravity * robot.mass;
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
