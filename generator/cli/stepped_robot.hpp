#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cli/read_inputs.hpp"
#include "cli/simulate_motion.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "interpreter/model.hpp"
#include "mechanism/coordinate.hpp"
#include "program/program.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// How long a robot is moved, and by which steps.
struct StepSettings {
  double seconds = 0;  ///< of one step; more than 0
  int steps = 1;
  bool stops = false;  ///< joints stop at their limits
};

/// A robot in a scene whose states are moved on through time, on its ground if it has one. It keeps
/// no state of its own.
class SteppedRobot {
 public:
  /// The ground's shapes are found on the robot's links.
  SteppedRobot(const Robot& robot, const Scene& scene, std::optional<GroundOfRobot> ground);

  /// q, qd and tau, whose entries of a floating base are a force and a moment on it.
  [[nodiscard]] const std::vector<Argument>& arguments() const { return arguments_; }
  /// q and qd, the mean force of the ground, and how many points it pressed in the last step.
  [[nodiscard]] const std::vector<Argument>& results() const { return results_; }
  /// Moves a number of states on, laid out as for `InterpretedRobot::call`. Results of arguments
  /// that are not finite, and of a motion that leaves the finite, are NaN.
  [[nodiscard]] std::vector<double> step(const StepSettings& settings, std::size_t states,
                                         const std::vector<double>& numbers) const;

 private:
  interpreter::Model<double> model_;
  std::vector<Coordinate> coordinates_;
  std::optional<GroundOfRobot> ground_;
  std::vector<Argument> arguments_, results_;
};

/// The robot of a scene on the ground of that scene. Errors: a mass matrix that is singular in
/// every pose; what no step holds, see `refuse_unheld`; a ground that
/// nothing can touch. Meshes that are missing are a warning.
std::optional<SteppedRobot> make_stepped_robot(const RobotAndScene& inputs,
                                               Diagnostics& diagnostics);

}  // namespace treeline
