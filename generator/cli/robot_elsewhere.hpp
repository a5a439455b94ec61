#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/simulation_options.hpp"
#include "drive/udp_robot.hpp"
#include "launch/launch.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Whether coordinates that were given, if any, are as many as the robot has; else with an error.
bool has_as_many(const drive::RobotDescription& robot, const std::vector<double>& given,
                 Diagnostics& diagnostics);

/// The coordinates at the beginning: those that were given, if any. Empty after an error.
std::vector<double> start_of(const LaunchedRobot& robot, const std::vector<double>& given,
                             Diagnostics& diagnostics);

/// The robot at an address, after its first state has come. Null after an error.
std::unique_ptr<drive::UdpRobot> find_robot(const LaunchedRobot& robot, const std::string& address,
                                            Diagnostics& diagnostics);

/// Simulates the robot for a loop in another process that talks to it over UDP at `address`, with
/// `rate` Hz, until a signal comes. Returns whether that was possible.
bool act_as_robot(const LaunchedRobot& robot, const std::vector<double>& given, double rate,
                  const SimulationNumbers& simulation, const std::string& address,
                  Diagnostics& diagnostics);

}  // namespace treeline
