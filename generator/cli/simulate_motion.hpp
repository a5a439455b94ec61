#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/surroundings.hpp"
#include "mechanism/coordinate.hpp"
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
  double stiffness = 0;       ///< joint force per displacement from the start, N/m or N m/rad
  /// m, of a floating robot's lowest point at the start; empty: as `q` says, without `q` on the
  /// ground where it would be in it
  std::optional<double> height;

  [[nodiscard]] bool has_joint_forces() const {
    return holds_weight || damping > 0 || stiffness > 0;
  }
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
  double energy_change = 0;   ///< J, at the end: of joints, of contacts, and an error
  double joint_work = 0;      ///< J of these: of joint forces and friction
  double contact_energy = 0;  ///< J of these: of the ground and stops
  double largest_change = 0;  ///< J, of all steps
  /// J of the change at the end that the integrator has made out of nothing.
  [[nodiscard]] double integrator_error() const {
    return energy_change - joint_work - contact_energy;
  }
  bool has_joint_forces = false;  ///< joint forces or friction may act
  bool has_contacts = false;      ///< a ground or stops may
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

/// Springs and dampers along every velocity.
struct JointSprings {
  simulation::Coordinates coordinates;
  simulation::Vector stiffness, damping;  ///< an entry for each velocity
  simulation::Vector rest;                ///< coordinates
};

/// Springs and dampers as `settings` has them, at rest at `start`, but of what floats on a ground.
/// With springs and fixed steps, both are as strong in each joint as the step permits: the
/// eigenvalues of M^-1 K step^2 and of M^-1 D step at the start are at most 1, where explicit
/// integrators are stable. A note names joints that are weaker for that.
JointSprings make_springs(const simulation::Model& model,
                          const std::vector<Coordinate>& coordinates,
                          const MotionSettings& settings, const simulation::State& start,
                          bool on_ground, Diagnostics& diagnostics);

/// Their joint forces.
simulation::Vector force_of(const JointSprings& springs, const simulation::State& state);

/// The ground, if there is one, for a model, on whose bodies the shapes are found by their links;
/// and, with `stops`, the ends of its joints' ranges.
std::optional<simulation::Ground> make_ground(const simulation::Model& model,
                                              const std::vector<Coordinate>& coordinates,
                                              const std::optional<GroundOfRobot>& ground,
                                              bool stops);

/// Whether any link can touch the ground; else with an error.
bool can_touch(const simulation::Ground& ground, Diagnostics& diagnostics);

/// How the ground, if there is one, answers in steps of so many seconds: what gravity makes in four
/// of them does not bounce, nor rounding.
std::optional<simulation::Surface> make_surface(const simulation::Model& model,
                                                const std::optional<GroundOfRobot>& ground,
                                                double step);

/// Whether a start is between the stops; else with an error that names the first joint that is not.
bool starts_between_stops(const std::vector<Coordinate>& coordinates,
                          const simulation::State& start, Diagnostics& diagnostics);

/// Moves a start so that no point is in the ground: floating robots up by what the lowest point
/// lacks, with a note, or to the height that is asked for. Errors: a start in the ground that was
/// given or of a robot that does not float; no shape that could touch the ground.
bool start_on_ground(const simulation::Model& model, const simulation::Ground& ground,
                     const MotionSettings& settings, simulation::State& state,
                     Diagnostics& diagnostics);

}  // namespace treeline
