#pragma once

namespace treeline::experiments {

/// Circles of tool and base (Chang fig. 6.6 to 6.11): after a rest both move in circles, with
/// smooth acceleration and deceleration. SI units and radians.
struct CirclePlan {
  /// q at the start: the tool is 1.63 m above the floor, and reaches forward and down with a high
  /// elbow.
  double start[9] = {0, 0, 0, 0, -1.42, 2.82, 0, 0.95, 0};
  double tool_radius = 0.1;   ///< in the vertical plane across the robot, m
  double base_radius = 0.05;  ///< on the floor, m; 0: the base shall stand
  double period = 4.0;        ///< of a round at full speed, s
  int rounds = 3;
  double ramp = 1.0;  ///< time until full speed, and until rest again, s
  double lead = 0.5;  ///< time at rest before, s
  double settle = 0.5;
  double rate = 1000.0;  ///< Hz

  double moving_time() const noexcept { return rounds * period + ramp; }
  double total() const noexcept { return lead + moving_time() + settle; }
};

/// Desired motion of tool and base at a time. The tool keeps its orientation, the base its yaw.
struct CircleMotion {
  double tool[3] = {};  ///< relative to the start, m
  double tool_velocity[3] = {};
  double tool_acceleration[3] = {};
  double base[3] = {};  ///< x, y, yaw
  double base_velocity[3] = {};
  double base_acceleration[3] = {};
};

/// Desired motion at `time`, in s since the run began.
CircleMotion circles_at(const CirclePlan& plan, double time) noexcept;

}  // namespace treeline::experiments
