#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/surroundings.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"
#include "simulation/step_on_ground.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

enum class Integrator { semi_implicit_euler, runge_kutta, adaptive };

/// How a robot is to be let go. Vectors are in the order of q and qd; empty ones are filled: q with
/// the middle of each joint's range (0 without limits, no turn for quaternions), qd with zeros.
struct MotionSettings {
  double seconds = 5;
  double step = 1e-3;  ///< s, of fixed steps; between rows of the table for the adaptive integrator
  double tolerance = 1e-10;  ///< of each adaptive step, relative and absolute
  Integrator integrator = Integrator::runge_kutta;
  std::vector<double> q, qd;
  bool holds_weight = false;  ///< joint forces cancel gravity
  double damping = 0;         ///< joint force per joint velocity, N s/m or N m s
  bool stops = false;         ///< joints stop at their limits
  double stiffness = 0;       ///< joint force per displacement from the start, N/m or N m
  /// m, of a floating robot's lowest point at the start; empty: as `q` says, without `q` on the
  /// ground where it would be in it
  std::optional<double> height;
};

/// The ground of a scene, and what of the robot may touch it.
struct GroundOfRobot {
  SceneGround law;
  std::vector<simulation::GroundShape> shapes;  ///< their links are named, bodies not yet known
};

/// A motion: a row a step with time, q, qd and energy, on a ground with contacts and force too, and
/// what became of what should not change.
struct Motion {
  report::Table table;
  int rows_planned = 0;       ///< fewer in the table: the motion was given up
  double start_energy = 0;    ///< J
  double energy_change = 0;   ///< J, at the end; an error where no force acts but gravity
  double largest_change = 0;  ///< J, of all steps
  bool has_quaternions = false;
  double quaternion_error = 0;  ///< largest | |quaternion| - 1 |
  int adaptive_steps = 0, rejected_steps = 0;
  std::optional<simulation::GroundAccount> ground = std::nullopt;
};

/// Runs the robot freely or on a ground, by forward dynamics of the generic interpreter. Errors: q
/// or qd of another length; a start in the ground; a mass matrix that cannot be inverted shows as a
/// motion given up.
std::optional<Motion> simulate_motion(const Robot& robot, const Scene& scene,
                                      const MotionSettings& settings,
                                      const std::optional<GroundOfRobot>& ground,
                                      Diagnostics& diagnostics);

/// Coordinates and energy over time.
report::Plot plot_motion(const std::string& robot, const Motion& motion);

}  // namespace treeline
