#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drive/wire.hpp"
#include "driving/reference.hpp"
#include "driving/simulation_options.hpp"
#include "launch/launch.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// How a robot is driven.
struct DriveSettings {
  double rate = 1000;  ///< Hz
  bool real_time = true;
  bool serves = true;                 ///< the page, to browsers
  std::optional<std::string> script;  ///< lines of the command language
  bool reads_input = false;           ///< commands from standard input
  std::string record;                 ///< file of JSON lines; empty: none
  std::vector<double> start;          ///< q; empty: 0, or what is nearest within the limits
  std::string listen = "127.0.0.1";
  int port = 0;  ///< 0: any
  std::vector<drive::ServedMesh> meshes;
  Reference reference;           ///< a motion to follow; empty: none
  SimulationNumbers simulation;  ///< of the simulated robot
  std::string udp_robot;         ///< HOST:PORT; empty: the robot is simulated
  bool has_controller = false;   ///< of its own, which gets the goals: `udp_robot` is its address
  std::string robot_secret;      ///< shared with the robot over UDP; empty: none
};

/// How a drive ended.
struct DriveOutcome {
  bool script_failed = false;  ///< a line was not obeyed
  bool script_cut = false;     ///< a signal came before its end
  bool record_failed = false;  ///< not all of it could be written
  std::string fault;           ///< of the loop, in words; empty: none
  std::string state;           ///< the last one, as front ends see it
};

/// Drives a robot until its script has ended, somebody says `quit`, or a signal comes; it then
/// brakes to rest. Without real time everything happens in this thread, and the same script gives
/// the same motion. Errors: `start` of another length; a record that cannot be written; an address
/// that cannot be listened on; no robot answers.
std::optional<DriveOutcome> run_drive(const LaunchedRobot& robot, const DriveSettings& settings,
                                      Diagnostics& diagnostics);

}  // namespace treeline
