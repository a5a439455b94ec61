#pragma once

#include <string>
#include <vector>

#include "plan.hpp"
#include "servo/plot.hpp"
#include "servo/table.hpp"

/// Chang chapter 8: the humanoid's left fist moves towards a point behind a wall, strikes the wall,
/// rebounds, and in the end presses against it. Everything that is computed of the robot is
/// generated code: control torque, forward dynamics, contact-space inverse inertia, effective mass,
/// response to impulses.
namespace treeline::experiments {

struct WallSettings {
  double restitution = 0.5;
  double friction = 0.4;
  double slow = 0.03;       ///< m/s: what approaches slower does not rebound
  double wall = 0.54;       ///< m, the wall's x; it faces the robot
  double behind = 0.05;     ///< m, of the goal behind it
  double reach_time = 0.6;  ///< s of the spline to the goal
  double duration = 1.5;    ///< s
  double rate = 1000;       ///< Hz of the control
  int substeps = 4;         ///< of integration in a control cycle
  double stiffness = 400;   ///< 1/s^2 of the hand
  double damping = 40;      ///< 1/s
};

/// One time that impulses acted.
struct WallBlow {
  double time = 0;      ///< s
  double approach = 0;  ///< m/s, speed into the wall before
  double parting = 0;   ///< m/s, speed out of it after
  double restitution = 0;
  double mass = 0;     ///< kg, effective mass along the wall's normal
  double impulse = 0;  ///< N s along the normal
  double energy = 0;   ///< J gained, (qd' M qd' - qd M qd) / 2
  double work = 0;     ///< J gained, y . (v + v') / 2
};

struct WallRun {
  servo::Table table;  ///< a row for each control cycle
  std::vector<WallBlow> blows;
  double deepest = 0;    ///< m, of the knuckles in the wall
  double pressing = 0;   ///< N on the wall, mean over the last 0.2 s
  double commanded = 0;  ///< N, (Lambda xdd_cmd)_x then: what the control law presses with at rest
};

/// `plan` says where the robot starts and how stiff its posture is.
WallRun run_hit_wall(const Plan& plan, const WallSettings& settings);

std::string hit_wall_summary(const WallRun& run, const WallSettings& settings);
servo::Plot hit_wall_figure(const WallRun& run);

/// The physical claims: the first blow is a real one and is returned with `restitution` times its
/// speed; each blow's energy is what its impulse does, and without friction falls by
/// (1 - e^2) / 2 m v^2; the hand stays out of the wall and in the end presses with what is
/// commanded.
bool hit_wall_claims_hold(const WallRun& run, const WallSettings& settings);

}  // namespace treeline::experiments
