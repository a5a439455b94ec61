#pragma once

namespace treeline::experiments {

/// Circles of tool and base (Chang fig. 6.6 to 6.11): after a lead at rest both go round at a speed
/// that is reached and left smoothly. SI units and radians.
struct CirclePlan {
  /// q at the start: the tool 1.63 m above the floor, reaching forward and down with a high elbow.
  double start[9] = {0, 0, 0, 0, -1.42, 2.82, 0, 0.95, 0};
  double tool_radius = 0.1;   ///< m, in the vertical plane across the robot
  double base_radius = 0.05;  ///< m, on the floor; 0: the base shall stand
  double period = 4.0;        ///< s a round at full speed
  int rounds = 3;
  double ramp = 1.0;  ///< s until full speed, and again to rest
  double lead = 0.5;  ///< s at rest before
  double settle = 0.5;
  double rate = 1000.0;  ///< Hz

  double moving_time() const noexcept { return rounds * period + ramp; }
  double total() const noexcept { return lead + moving_time() + settle; }
};

/// What tool and base shall do at a time. The tool keeps its orientation, the base its yaw.
struct CircleMotion {
  double tool[3] = {};  ///< m, less where it starts
  double tool_velocity[3] = {};
  double tool_acceleration[3] = {};
  double base[3] = {};  ///< x, y, yaw
  double base_velocity[3] = {};
  double base_acceleration[3] = {};
};

/// `time` in s since the run began.
CircleMotion circles_at(const CirclePlan& plan, double time) noexcept;

}  // namespace treeline::experiments
