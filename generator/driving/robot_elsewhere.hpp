#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drive/udp_robot.hpp"
#include "driving/simulation_options.hpp"
#include "launch/launch.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Whether coordinates that were given, if any, are as many as the robot has; else with an error.
bool has_as_many(const drive::RobotDescription& robot, const std::vector<double>& given,
                 Diagnostics& diagnostics);

/// The coordinates at the beginning: those that were given, if any. Empty after an error.
std::vector<double> start_of(const LaunchedRobot& robot, const std::vector<double>& given,
                             Diagnostics& diagnostics);

/// A place on the network, HOST:PORT, and the secret that both sides share; empty: none.
struct Elsewhere {
  std::string address;
  std::string secret;
  bool has_controller = false;  ///< there is a control loop, which moves its robot itself
};

/// The secret that both sides share: the text of `file`, else of the environment variable
/// TREELINE_ROBOT_SECRET. Empty, with a warning, where neither is given. Errors: a file that cannot
/// be read; fewer than 16 characters.
std::optional<std::string> read_robot_secret(const std::string& file, Diagnostics& diagnostics);

/// The robot or the controller at an address, after its first state has come. Null after an error.
std::unique_ptr<drive::UdpRobot> find_robot(const LaunchedRobot& robot, const Elsewhere& elsewhere,
                                            Diagnostics& diagnostics);

/// Simulates the robot for a loop in another process that talks to it over UDP at `elsewhere`, with
/// `rate` Hz, until a signal comes. Returns whether that was possible.
bool act_as_robot(const LaunchedRobot& robot, const std::vector<double>& given, double rate,
                  const SimulationNumbers& simulation, const Elsewhere& elsewhere,
                  Diagnostics& diagnostics);

}  // namespace treeline
