#include "cli/simulate.hpp"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/exit_code.hpp"
#include "cli/option_values.hpp"
#include "cli/print_diagnostics.hpp"
#include "cli/read_robot_files.hpp"
#include "cli/simulate_motion.hpp"
#include "cli/write_output.hpp"
#include "oracle/leave_out_singular.hpp"
#include "text/json_text.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

struct SimulateOptions {
  std::string urdf, scene;
  MotionSettings motion;
  std::string csv, svg;
  bool json = false;
  Warnings warnings = Warnings::summary;
};

const std::vector<std::pair<std::string, Integrator>> kIntegrators = {
    {"euler", Integrator::semi_implicit_euler},
    {"rk4", Integrator::runge_kutta},
    {"adaptive", Integrator::adaptive}};

bool gave_up(const Motion& motion) {
  return static_cast<int>(motion.table.rows()) < motion.rows_planned;
}

double last_time(const Motion& motion) {
  return motion.table.rows() == 0 ? 0 : motion.table.at(motion.table.rows() - 1, 0);
}

std::string print_text(const std::string& robot, const MotionSettings& settings,
                       const Motion& motion) {
  const bool conserves = !settings.holds_weight && settings.damping == 0;
  std::string text = fmt::format(
      "{}: {:g} s, {} rows\n"
      "  energy at the start    {:.6g} J\n"
      "  change at the end      {:.3e} J{}\n"
      "  largest change         {:.3e} J\n",
      robot, last_time(motion), motion.table.rows(), motion.start_energy, motion.energy_change,
      conserves ? ", the integrator's error" : ", to which joint forces contribute",
      motion.largest_change);
  if (motion.adaptive_steps > 0) {
    text += fmt::format("  steps                  {}, {} tried and found too long\n",
                        motion.adaptive_steps, motion.rejected_steps);
  }
  if (motion.has_quaternions) {
    text +=
        fmt::format("  quaternions            {:.1e} off unit length\n", motion.quaternion_error);
  }
  if (gave_up(motion)) {
    text += fmt::format(
        "GIVEN UP after {:g} s: energy out of nothing, or ever shorter steps; try "
        "a shorter --step\n",
        last_time(motion));
  }
  return text;
}

std::string print_json(const std::string& robot, const Motion& motion) {
  const nlohmann::ordered_json json = {{"robot", robot},
                                       {"seconds", last_time(motion)},
                                       {"rows", motion.table.rows()},
                                       {"given_up", gave_up(motion)},
                                       {"start_energy", motion.start_energy},
                                       {"energy_change", motion.energy_change},
                                       {"largest_change", motion.largest_change},
                                       {"quaternion_error", motion.quaternion_error},
                                       {"adaptive_steps", motion.adaptive_steps},
                                       {"rejected_steps", motion.rejected_steps}};
  return json_text(json);
}

bool write_files(const SimulateOptions& options, const RobotWithFiles& of, const Motion& motion,
                 Diagnostics& diagnostics) {
  const std::vector<std::string> read = list_paths(of.files);
  const bool to_file = !options.csv.empty() && options.csv != "-";
  if (to_file &&
      !write_output_file(options.csv, report::csv_text(motion.table), diagnostics, read)) {
    return false;
  }
  return options.svg.empty() ||
         write_output_file(options.svg, report::svg_text(plot_motion(of.robot.name, motion)),
                           diagnostics, read);
}

/// Writes the results. With `--csv -` the table goes to standard output, the summary to messages.
ExitCode write_data(const SimulateOptions& options, const std::string& robot, const Motion& motion,
                    ExitCode exit_code) {
  const std::string summary =
      options.json ? print_json(robot, motion) : print_text(robot, options.motion, motion);
  const OutputForm form = options.json ? OutputForm::json : OutputForm::text;
  if (options.csv != "-") return write_output(summary, form, exit_code);
  print_message(printable_lines(summary));
  return write_output(report::csv_text(motion.table), OutputForm::text, exit_code);
}

int simulate(const SimulateOptions& options, Diagnostics& diagnostics) {
  const auto read = read_robot_files(options.urdf, options.scene, diagnostics);
  const auto scene = read ? parse_scene_of(*read, diagnostics) : std::nullopt;
  if (!scene || !has_accelerations(read->robot, *scene, diagnostics)) return kBadInput;
  const auto motion = simulate_motion(read->robot, *scene, options.motion, diagnostics);
  if (!motion) return kBadInput;
  const ExitCode exit_code = !write_files(options, *read, *motion, diagnostics) ? kBadInput
                             : gave_up(*motion)                                 ? kMismatch
                                                                                : kOk;
  return write_data(options, read->robot.name, *motion, exit_code);
}

void add_motion_options(CLI::App& command, MotionSettings& motion) {
  command.add_option("--seconds", motion.seconds, "How long")
      ->check(between(1e-6, 1e6))
      ->capture_default_str();
  command.add_option("--step", motion.step, "s; adaptive steps are only recorded so often")
      ->check(between(1e-9, 10))
      ->capture_default_str();
  command.add_option("--integrator", motion.integrator, "euler (semi-implicit), rk4 or adaptive")
      ->transform(one_of(kIntegrators));
  command.add_option("--tolerance", motion.tolerance, "Error allowed to an adaptive step")
      ->check(between(1e-15, 1))
      ->capture_default_str();
  command.add_option("--q", motion.q, "Where it starts, separated by commas; else mid-range")
      ->delimiter(',')
      ->check(any_number());
  command.add_option("--qd", motion.qd, "How fast it starts; else at rest")
      ->delimiter(',')
      ->check(any_number());
  command.add_flag("--hold", motion.holds_weight, "Joint forces cancel gravity");
  command.add_option("--damping", motion.damping, "Joint force per joint velocity")
      ->check(between(0, 1e12));
}

}  // namespace

void add_simulate(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* command =
      app.add_subcommand("simulate", "Let a robot go, and tell what became of its energy");
  command->add_option("urdf", options->urdf, kRobotArgument)->required();
  command->add_option("scene", options->scene, "Base, gravity, locked joints; YAML");
  add_motion_options(*command, options->motion);
  command->add_option("--csv", options->csv, "Table of time, q, qd, energy; - is standard output");
  command->add_option("--svg", options->svg, "The same drawn");
  command->add_flag("--json", options->json, "Summary as JSON");
  add_warnings_option(*command, options->warnings);
  command->footer(
      "Exit: 3 when the motion had to be given up.\n"
      "Examples:\n"
      "  treeline simulate puma560.urdf --seconds 2 --svg swing.svg\n"
      "  treeline simulate humanoid24.urdf scene_floating.yaml --integrator adaptive --json\n"
      "  treeline simulate planar3r.urdf --q 0,1,0 --qd 1,0,-1 --hold --csv - | head");
  command->callback([options, &exit_code] {
    Diagnostics diagnostics;
    exit_code = simulate(*options, diagnostics);
    print_diagnostics(diagnostics, options->warnings);
  });
}

}  // namespace treeline
