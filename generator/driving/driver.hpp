#pragma once

#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drive/reference_motion.hpp"
#include "drive/robot_description.hpp"
#include "drive/wire.hpp"
#include "driving/simulation_options.hpp"
#include "launch/launch.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// A motion that a driven robot can follow.
struct Reference {
  std::vector<double> times;  ///< s, growing
  std::vector<double> q;      ///< a row a time

  /// For a loop; points into this object.
  [[nodiscard]] drive::RecordedMotion motion() const {
    return {times.data(), q.data(), static_cast<int>(times.size())};
  }
};

/// Reads a record of `drive`, or a table as `treeline draw --motion` takes it. `home` stands for
/// coordinates that it does not have. Errors: those of reading; fewer than two moments; coordinates
/// beyond the limits of the robot.
std::optional<Reference> read_reference(const std::string& path,
                                        const drive::RobotDescription& robot,
                                        const std::vector<double>& home, Diagnostics& diagnostics);

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

/// The file of `--record`: JSON lines, of which the first is the `hello` of the drive.
class RecordWriter {
 public:
  /// `file` empty: nothing is recorded.
  explicit RecordWriter(std::string file) : file_(std::move(file)) {}

  bool open(const std::string& hello, Diagnostics& diagnostics);
  bool is_wanted() const { return !file_.empty(); }
  /// Whether the state of `time` (s) is to be recorded: a hundred are a second.
  bool wants_state(double time);
  /// Writes a line. The first that cannot be written is said; the robot goes on without its record.
  void write(const std::string& line, double time);
  /// Writes what is left. Returns whether all of the record has been written.
  bool close(double time);

 private:
  void watch(double time);

  std::string file_;
  std::ofstream stream_;
  double recorded_ = -1;
  bool failed_ = false;
};

/// Readies the process for a robot that is driven: nobody who stops reading what is said or
/// recorded, and no limit on the size of files, ends it, and threads that begin later take little
/// of the memory that is locked. Call this before they begin.
void outlast_others();

}  // namespace treeline
