#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "drive/robot_description.hpp"
#include "drive/robot_library.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Options of `treeline drive` that make the simulated robot like a real one, as they are written:
/// each a number for all joints or JOINT=NUMBER, several separated by commas.
struct SimulationTexts {
  std::vector<std::string> friction, viscous, backlash, rotor, gear_stiffness, noise, quantisation;
  double delay = 0;  ///< s

  /// The first option that asks for something; empty: none does.
  [[nodiscard]] std::string first_given() const;
};

void add_simulation_options(CLI::App& command, SimulationTexts& texts);

/// Numbers of these options, one for each velocity.
struct SimulationNumbers {
  std::vector<double> friction, viscous, backlash, rotor, gear_stiffness, noise, quantisation;
  int delay = 0;  ///< cycles

  /// Options for a loop; the result points into this object.
  [[nodiscard]] drive::SimulationOptions options() const;
};

/// Errors: no number, a negative one, a joint that the robot has not or that has no coordinate of
/// its own, play without a rotor or with teeth that do not push, a delay of too many cycles of a
/// loop at `rate` (Hz).
std::optional<SimulationNumbers> read_simulation(const SimulationTexts& texts,
                                                 const drive::RobotDescription& robot, double rate,
                                                 Diagnostics& diagnostics);

}  // namespace treeline
