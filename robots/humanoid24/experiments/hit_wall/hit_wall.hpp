#pragma once

#include <string>
#include <vector>

#include "plan.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"
#include "servo/safety.hpp"

/// Chang chapter 8: the humanoid's left fist moves towards a point behind a wall, strikes the wall,
/// rebounds, and finally presses against it. All computations for the robot are generated code:
/// control torque, forward dynamics, contact-space inverse inertia, effective mass, response to
/// impulses.
namespace treeline::experiments {

struct WallSettings {
  double restitution = 0.5;
  double friction = 0.4;
  double slow = 0.03;       ///< slower approaches do not rebound, m/s
  double wall = 0.515;      ///< x of the wall, m; it faces the robot
  double behind = 0.05;     ///< distance of the goal behind the wall, m
  double reach_time = 0.6;  ///< duration of the spline to the goal, s
  double duration = 3.0;    ///< s
  double rate = 1000;       ///< of the control, Hz
  int substeps = 4;         ///< integration steps per control cycle
  double stiffness = 400;   ///< of the hand, 1/s^2
  double damping = 40;      ///< of the hand, 1/s
};

/// One blow on the wall.
struct WallBlow {
  double time = 0;      ///< s
  double approach = 0;  ///< speed into the wall before, m/s
  double parting = 0;   ///< speed out of it after, m/s
  double restitution = 0;
  double mass = 0;     ///< effective mass along the wall's normal, kg
  double impulse = 0;  ///< along the normal, N s
  double energy = 0;   ///< J gained, (qd' M qd' - qd M qd) / 2
  double work = 0;     ///< J gained, y . (v + v') / 2
};

struct WallRun {
  report::Table table;  ///< one row per control cycle
  std::vector<WallBlow> blows;
  servo::Fault fault;    ///< of the servo loop, which ends the run
  double swing = 0;      ///< largest speed of a joint before the first blow, rad/s
  double deepest = 0;    ///< largest depth of the knuckles in the wall, m
  double pressing = 0;   ///< mean force on the wall over the last 0.2 s, N
  double commanded = 0;  ///< mean of (Lambda xdd_cmd)_x over that time, N: the commanded force
};

/// Simulates the experiment, controlled by the servo loop. `plan` gives the robot's start and the
/// springs of its posture.
WallRun run_hit_wall(const Plan& plan, const WallSettings& settings);

std::string hit_wall_summary(const WallRun& run, const WallSettings& settings);
report::Plot hit_wall_figure(const WallRun& run);

/// Whether the physical claims hold: the first blow is a real one and is returned with
/// `restitution` times its speed, after a reach in which no joint swings. Each blow changes the
/// energy by the work of its impulse, and without friction it falls by (1 - e^2) / 2 m v^2. The
/// hand stays out of the wall, and in the end it presses with the commanded force.
bool hit_wall_claims_hold(const WallRun& run, const WallSettings& settings);

}  // namespace treeline::experiments
