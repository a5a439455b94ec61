#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>

#include "cli/commands.hpp"
#include "cli/find_all_meshes.hpp"
#include "cli/read_inputs.hpp"
#include "cli/record.hpp"
#include "description/read_surroundings.hpp"
#include "drawing/show_held_objects.hpp"
#include "driving/driver.hpp"
#include "driving/find_start.hpp"
#include "driving/latency.hpp"
#include "driving/loop_handle.hpp"
#include "driving/robot_elsewhere.hpp"
#include "driving/simulation_options.hpp"
#include "launch/launch.hpp"
#include "launch/split_ball_joints.hpp"
#include "terminal/exit_code.hpp"
#include "terminal/option_values.hpp"
#include "terminal/progress_line.hpp"
#include "terminal/write_output.hpp"
#include "text/read_text_file.hpp"

namespace treeline {
namespace {

constexpr std::string_view kUdp = "udp:";
constexpr std::string_view kController = "controller:";

struct DriveOptions {
  InputOptions inputs;
  DriveSettings drive;
  SimulationTexts simulation;
  LatencySettings latency;
  bool measures_latency = false;
  std::string script, reference, replay;
  MeshOptions meshes;
  bool headless = false;
  bool ground = false;
  std::string robot = "simulated";
  std::string act_as_robot, robot_secret;
};

/// URDF of the robot that is driven and shown: a ball joint is three hinges.
std::string driven_urdf(const RobotFiles& files) {
  return split_ball_joints(shown_urdf(files));
}

/// Reads the options about this robot: how the simulated one is not ideal, and the motion to
/// follow.
bool read_motion_and_robot(DriveOptions& options, const drive::RobotDescription& robot,
                           Diagnostics& diagnostics) {
  DriveSettings& drive = options.drive;
  auto simulation = read_simulation(options.simulation, robot, drive.rate, diagnostics);
  if (!simulation || !has_as_many(robot, drive.start, diagnostics)) return false;
  drive.simulation = std::move(*simulation);
  if (options.reference.empty()) return true;
  auto reference = read_reference(options.reference, robot, default_start(robot), diagnostics);
  if (!reference) return false;
  drive.reference = std::move(*reference);
  return true;
}

/// The robot of the options' files, ready to be driven; sets the meshes that pictures of it need.
std::optional<LaunchedRobot> launch_from(DriveOptions& options, const drive::MeshPlaces& places,
                                         Diagnostics& diagnostics) {
  auto inputs = read_inputs(options.inputs, diagnostics);
  if (!inputs || !is_none_of(options.drive.record, list_paths(inputs->files), diagnostics)) {
    return std::nullopt;
  }
  split_ball_joints(inputs->robot, inputs->scene, diagnostics);
  options.drive.meshes = find_all_meshes(inputs->files, places);
  if (options.drive.serves) warn_of_missing(options.drive.meshes, "shown", diagnostics);
  const auto tell = [](const std::string& what) {
    if (is_watched()) show_progress("  " + what);
  };
  auto surroundings = surroundings_of(inputs->files.scene_text, inputs->robot);
  if (options.ground && !surroundings.ground) surroundings.ground.emplace();
  // A robot elsewhere stands on what it stands on.
  if (!options.drive.udp_robot.empty()) surroundings.ground.reset();
  if (surroundings.ground) {
    inputs->scene.touches = read_touches(inputs->files, places, diagnostics);
  }
  const auto accepts = [&](const drive::RobotDescription& robot) {
    return read_motion_and_robot(options, robot, diagnostics);
  };
  auto robot =
      launch({std::move(inputs->robot), std::move(inputs->scene), driven_urdf(inputs->files),
              inputs->files.scene_text, std::move(surroundings)},
             accepts, tell, diagnostics);
  if (is_watched()) show_progress("");
  if (robot) robot->description.has_reference = !options.reference.empty();
  if (robot && options.drive.has_controller) {
    robot->description.has_controller = true;
    robot->description.links.clear();  // none can be pulled
  }
  return robot;
}

/// The secret that a robot over UDP shares, where there is one.
bool read_secret(DriveOptions& options, Diagnostics& diagnostics) {
  if (options.drive.udp_robot.empty() && options.act_as_robot.empty()) return true;
  auto secret = read_robot_secret(options.robot_secret, diagnostics);
  if (secret) options.drive.robot_secret = std::move(*secret);
  return secret.has_value();
}

/// Warns where others than this machine can connect.
void warn_of_listeners(const DriveSettings& drive, Diagnostics& diagnostics) {
  if (!drive.serves || drive.listen == "127.0.0.1" || drive.listen == "::1") return;
  diagnostics.add({Severity::warning, "", 0, "--listen",
                   fmt::format("everybody who reaches {} can watch and stop, and whoever has the "
                               "token can command; nothing is encrypted",
                               drive.listen),
                   "Without it only this machine can connect; `ssh -L` reaches it from others."});
}

bool read_script(const std::string& path, DriveSettings& drive, Diagnostics& diagnostics) {
  if (path.empty()) return true;
  const auto text = read_text_file(path, diagnostics);
  if (text) drive.script = *text;
  return text.has_value();
}

/// A robot elsewhere has the friction that it has.
void refuse_imperfect_hardware(const DriveOptions& options, Diagnostics& diagnostics) {
  const std::string given = options.ground ? "--ground" : options.simulation.first_given();
  if (given.empty() || options.drive.udp_robot.empty()) return;
  diagnostics.add({Severity::error, "", 0, given, "this is of a simulated robot, --robot is not",
                   "Give it to the process that has --act-as-robot."});
}

/// A record would take the place of what is followed. `launch_from` looks at the robot's files.
void refuse_record_of_input(const DriveOptions& options, Diagnostics& diagnostics) {
  (void)is_none_of(options.drive.record, {options.script, options.reference}, diagnostics);
}

/// Shows a recorded drive again. It needs no loop and no code, only the files of the recording.
int run_replay(const DriveOptions& options) {
  Diagnostics diagnostics;
  const auto places = read_mesh_places(options.meshes, diagnostics);
  const auto inputs = places ? read_inputs(options.inputs, diagnostics) : std::nullopt;
  bool shown = false;
  if (inputs) {
    std::string urdf = driven_urdf(inputs->files);
    const std::string checksum = checksum_of(urdf, inputs->files.scene_text);
    const auto record = is_table(options.replay)
                            ? record_of_table(options.replay, *inputs, checksum, diagnostics)
                            : read_record(options.replay, checksum, diagnostics);
    const auto shapes = surroundings_of(inputs->files.scene_text, inputs->robot).shapes;
    if (is_table(options.replay)) urdf = show_held_objects(urdf, inputs->scene, shapes);
    const PageSettings page{options.drive.listen, options.drive.port, urdf,
                            find_all_meshes(inputs->files, *places)};
    warn_of_listeners(options.drive, diagnostics);
    shown = record && replay(*record, page, diagnostics);
  }
  print_diagnostics(diagnostics, options.inputs.warnings);
  return shown ? kOk : kBadInput;
}

/// Chooses where a simulated robot starts. One that can hold its weight at no place that was found
/// is driven without the limits that say so: its file has placeholders, and it could only fall.
void choose_start(LaunchedRobot& robot, DriveSettings& drive, Diagnostics& diagnostics) {
  if (!drive.start.empty() || !drive.udp_robot.empty()) return;
  drive.start = start_of(robot, {}, diagnostics);
  if (drive.start.empty()) return;
  const std::string weak =
      free_weak_robot(robot.library.functions(), robot.description, drive.start);
  if (weak.empty()) return;
  diagnostics.add({Severity::warning, "", 0, "--q",
                   "the robot can hold its weight at no place that was found: " + weak,
                   "The file's effort limits are left out while it is driven; where --q states a "
                   "place they are kept."});
}

/// HOST:PORT of a robot, or a controller, elsewhere; empty: it is simulated.
std::string address_of_robot(const std::string& robot) {
  for (const std::string_view kind : {kUdp, kController}) {
    if (robot.starts_with(kind)) return robot.substr(kind.size());
  }
  return {};
}

/// Completes the settings that follow from several options.
void complete_settings(DriveOptions& options) {
  DriveSettings& drive = options.drive;
  drive.serves = !options.headless;
  drive.has_controller = options.robot.starts_with(kController);
  drive.udp_robot = address_of_robot(options.robot);
  drive.reads_input = options.script.empty();
  const bool is_typed = drive.reads_input && isatty(STDIN_FILENO) != 0;
  drive.real_time = drive.real_time || drive.serves || is_typed || !drive.udp_robot.empty();
}

/// Nobody should wait for a motion, or ten minutes for a measurement, to lose it then.
bool can_write_results(const DriveOptions& options, Diagnostics& diagnostics) {
  const std::string& report = options.latency.report;
  return (options.drive.record.empty() || can_write(options.drive.record, diagnostics)) &&
         (report.empty() ||
          (can_write(report + ".json", diagnostics) && can_write(report + ".svg", diagnostics)));
}

/// The robot and all that it is driven with. Everything that can be refused is refused here.
std::optional<LaunchedRobot> prepare(DriveOptions& options, Diagnostics& diagnostics) {
  DriveSettings& drive = options.drive;
  warn_of_listeners(drive, diagnostics);
  const auto places = read_mesh_places(options.meshes, diagnostics);
  refuse_imperfect_hardware(options, diagnostics);
  refuse_record_of_input(options, diagnostics);
  if (!places || diagnostics.has_errors()) return std::nullopt;
  if (!read_script(options.script, drive, diagnostics)) return std::nullopt;
  if (!can_write_results(options, diagnostics)) return std::nullopt;
  if (!read_secret(options, diagnostics)) return std::nullopt;
  auto robot = launch_from(options, *places, diagnostics);
  if (!robot) return std::nullopt;
  choose_start(*robot, drive, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return robot;
}

ExitCode exit_code_of(const DriveOutcome& outcome) {
  if (outcome.script_failed || outcome.script_cut || outcome.record_failed) return kBadInput;
  return outcome.fault.empty() ? kOk : kMismatch;
}

int run(DriveOptions options) {
  if (!options.replay.empty()) return run_replay(options);
  complete_settings(options);
  Diagnostics diagnostics;
  const auto robot = prepare(options, diagnostics);
  print_diagnostics(diagnostics, options.inputs.warnings);
  if (!robot) return kBadInput;
  const DriveSettings& drive = options.drive;
  Diagnostics of_drive;
  if (!options.act_as_robot.empty()) {
    const bool acted = act_as_robot(*robot, drive.start, drive.rate, drive.simulation,
                                    {options.act_as_robot, drive.robot_secret}, of_drive);
    print_diagnostics(of_drive, options.inputs.warnings);
    return acted ? kOk : kBadInput;
  }
  if (options.measures_latency) {
    const ExitCode exit_code = measure_latency(*robot, drive, options.latency, of_drive);
    print_diagnostics(of_drive, options.inputs.warnings);
    return exit_code;
  }
  const auto outcome = run_drive(*robot, drive, of_drive);
  print_diagnostics(of_drive, options.inputs.warnings);
  if (!outcome) return kBadInput;
  const ExitCode exit_code = exit_code_of(*outcome);
  if (!options.headless) return exit_code;
  return write_output(outcome->state + "\n", OutputForm::json, exit_code);
}

void add_robot_options(CLI::App& command, DriveOptions& options) {
  add_mesh_options(command, options.meshes);
  command
      .add_option(
          "--robot", options.robot,
          "simulated; udp:HOST:PORT, a robot that takes torques; controller:HOST:PORT, your "
          "control loop, which takes goals")
      ->check([](const std::string& given) {
        return given == "simulated" || drive::is_udp_address(address_of_robot(given))
                   ? std::string()
                   : fmt::format(
                         "\"{}\" is no robot\nsimulated, or udp:HOST:PORT or "
                         "controller:HOST:PORT with a number as HOST, as in udp:192.168.1.7:7000",
                         given);
      })
      ->capture_default_str();
  command.add_option("--robot-secret", options.robot_secret,
                     "File of a secret that both sides of a robot over UDP share; else "
                     "$TREELINE_ROBOT_SECRET");
  command
      .add_option("--act-as-robot", options.act_as_robot,
                  "HOST:PORT: be the simulated robot of a drive in another process")
      ->check([](const std::string& given) {
        return drive::is_udp_address(given)
                   ? std::string()
                   : fmt::format(
                         "\"{}\" is no address\nHOST:PORT of this machine with a number as "
                         "HOST, as in 127.0.0.1:7000",
                         given);
      });
}

void add_drive_options(CLI::App& command, DriveOptions& options) {
  DriveSettings& drive = options.drive;
  drive.real_time = false;
  command.add_flag("--headless", options.headless,
                   "No page: commands from --script or standard input alone");
  command.add_option("--script", options.script,
                     "File of commands, one a line; - is standard input");
  command.add_option("--record", drive.record, "JSON lines of commands and, 100 a second, states")
      ->check(no_input_file());
  command.add_option("--reference", options.reference,
                     "Motion for the command `follow`: a record, or a table of simulate --csv");
  command
      .add_option("--replay", options.replay,
                  "Show this motion in the page instead, a record, or a table of simulate --csv or "
                  "of an experiment; nothing is simulated")
      ->excludes("--headless", "--script", "--record", "--reference");
  command.add_flag("--real-time", drive.real_time,
                   "Keep to the machine's clock; always so with the page, a terminal or --robot");
  command.add_option("--rate", drive.rate, "Cycles of the control loop a second")
      ->check(between(50, 10000))
      ->capture_default_str();
  command.add_option("--port", drive.port, "Of the page; 0: any that is free")
      ->check(whole_between(0, 65535))
      ->capture_default_str();
  command
      .add_option("--listen", drive.listen,
                  "Address of this machine that others may reach; they can watch")
      ->capture_default_str();
  add_robot_options(command, options);
  command.add_flag("--ground", options.ground,
                   "It stands on the ground z < 0, also where the scene has no key `ground`");
  command.add_option("--q", drive.start, "Where it starts, separated by commas; else near 0")
      ->delimiter(',')
      ->check(any_number());
  add_simulation_options(command, options.simulation);
  auto* latency = command.add_flag("--latency", options.measures_latency,
                                   "Measure period, jitter and control time in real time instead");
  latency->excludes("--script", "--record", "--reference", "--replay", "--act-as-robot");
  const char* const kGroup = "With --latency";
  command.add_option("--seconds", options.latency.seconds, "For so long")
      ->check(between(1, 86400))
      ->capture_default_str()
      ->needs(latency)
      ->group(kGroup);
  command
      .add_option("--load", options.latency.load, "Threads that keep the machine busy meanwhile")
      ->check(whole_between(0, 256))
      ->capture_default_str()
      ->needs(latency)
      ->group(kGroup);
  command.add_option("--report", options.latency.report, "Write PREFIX.json and PREFIX.svg")
      ->needs(latency)
      ->group(kGroup);
}

}  // namespace

void add_drive(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<DriveOptions>();
  options->inputs.functions_from = FunctionsFrom::command;
  options->inputs.limits_for = LimitUse::drive;
  CLI::App* command = app.add_subcommand("drive", "Drive a simulated robot by its generated code");
  command->add_option("urdf", options->inputs.urdf, kRobotArgument)->required();
  command->add_option("scene", options->inputs.scene,
                      "Operational points, base, gravity; YAML; without: the joints alone");
  add_drive_options(*command, *options);
  add_warnings_option(*command, options->inputs.warnings);
  command->footer(
      "Commands (docs/reference/driving.md explains them): start, stop, brake, reset,\n"
      "mode joint|task|gravity, joint NAME to 45 deg in 2 s, move POINT by 0 0 -0.1 in 2 s,\n"
      "turn POINT by 0 0 90 deg, hold, wait, help, quit.\n"
      "Ctrl-C brakes to rest and ends. Exit: 1 a line of the script was not obeyed, a signal came\n"
      "before its end, or the record could not be written; 3 the robot ended in a fault. Compiled "
      "code is kept for the next drive of the same robot and scene, in\n"
      "$TREELINE_CACHE, else ~/.cache/treeline; TREELINE_CACHE= keeps none.\n"
      "Examples:\n"
      "  treeline drive puma560.urdf scene.yaml\n"
      "  treeline drive arm.urdf --headless --script motion.txt --record motion.jsonl\n"
      "  treeline drive arm.urdf --replay motion.jsonl\n"
      "  echo 'start' | treeline drive arm.urdf --headless");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace treeline
