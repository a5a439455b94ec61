#include "cli/simulate.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/exit_code.hpp"
#include "cli/read_inputs.hpp"
#include "cli/simulate_motion.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"

namespace treeline {
namespace {

struct SimulateOptions {
  std::string urdf, scene;
  MotionSettings motion;
  std::string csv, svg;
  bool json = false;
};

const std::map<std::string, Integrator> kIntegrators = {{"euler", Integrator::semi_implicit_euler},
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
  text += fmt::format("  quaternions            {:.1e} off unit length\n", motion.quaternion_error);
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
  return json.dump(2) + "\n";
}

std::optional<Scene> scene_of(const SimulateOptions& options, const Robot& robot,
                              Diagnostics& diagnostics) {
  return options.scene.empty() ? parse_scene("", "", robot, diagnostics)
                               : read_scene(options.scene, robot, diagnostics);
}

bool write(const std::string& path, const std::string& text, Diagnostics& diagnostics) {
  const std::string error = servo::write_text(path, text);
  if (error.empty()) return true;
  diagnostics.add({Severity::error, path, 0, "", error, "Name a file in a folder that exists."});
  return false;
}

/// With `--csv -` the table is the data and what is said about it a message.
bool deliver(const SimulateOptions& options, const std::string& robot, const Motion& motion,
             Diagnostics& diagnostics) {
  const bool table_out = options.csv == "-";
  fmt::print(table_out ? stderr : stdout, "{}",
             options.json ? print_json(robot, motion) : print_text(robot, options.motion, motion));
  if (table_out) {
    fmt::print("{}", servo::csv_text(motion.table));
  } else if (!options.csv.empty() &&
             !write(options.csv, servo::csv_text(motion.table), diagnostics)) {
    return false;
  }
  return options.svg.empty() ||
         write(options.svg, servo::svg_text(plot_motion(robot, motion)), diagnostics);
}

int simulate(const SimulateOptions& options, Diagnostics& diagnostics) {
  const auto robot = read_urdf(options.urdf, diagnostics);
  if (!robot) return kBadInput;
  const auto scene = scene_of(options, *robot, diagnostics);
  if (!scene) return kBadInput;
  const auto motion = simulate_motion(*robot, *scene, options.motion, diagnostics);
  if (!motion || !deliver(options, robot->name, *motion, diagnostics)) return kBadInput;
  return gave_up(*motion) ? kMismatch : kOk;
}

void add_motion_options(CLI::App& command, MotionSettings& motion) {
  command.add_option("--seconds", motion.seconds, "How long")
      ->check(CLI::Range(1e-6, 1e6))
      ->capture_default_str();
  command.add_option("--step", motion.step, "s; adaptive steps are only recorded so often")
      ->check(CLI::Range(1e-9, 10.0))
      ->capture_default_str();
  command.add_option("--integrator", motion.integrator, "euler (semi-implicit), rk4 or adaptive")
      ->transform(CLI::CheckedTransformer(kIntegrators).description(""));
  command.add_option("--tolerance", motion.tolerance, "Error allowed to an adaptive step")
      ->check(CLI::Range(1e-15, 1.0))
      ->capture_default_str();
  command.add_option("--q", motion.q, "Where it starts, separated by commas; else mid-range")
      ->delimiter(',');
  command.add_option("--qd", motion.qd, "How fast it starts; else at rest")->delimiter(',');
  command.add_flag("--hold", motion.holds_weight, "Joint forces cancel gravity");
  command.add_option("--damping", motion.damping, "Joint force per joint velocity")
      ->check(CLI::NonNegativeNumber);
}

}  // namespace

void add_simulate(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* command =
      app.add_subcommand("simulate", "Let a robot go, and tell what became of its energy");
  command->add_option("urdf", options->urdf, "Robot, URDF")->required();
  command->add_option("scene", options->scene, "Base, gravity, locked joints; YAML");
  add_motion_options(*command, options->motion);
  command->add_option("--csv", options->csv, "Table of time, q, qd, energy; - is standard output");
  command->add_option("--svg", options->svg, "The same drawn");
  command->add_flag("--json", options->json, "Summary as JSON");
  command->footer(
      "Exit: 3 when the motion had to be given up.\n"
      "Examples:\n"
      "  treeline simulate puma560.urdf --seconds 2 --svg swing.svg\n"
      "  treeline simulate humanoid24.urdf scene_floating.yaml --integrator adaptive --json\n"
      "  treeline simulate planar3r.urdf --q 0,1,0 --qd 1,0,-1 --hold --csv - | head");
  command->callback([options, &exit_code] {
    Diagnostics diagnostics;
    exit_code = simulate(*options, diagnostics);
    print_diagnostics(diagnostics);
  });
}

}  // namespace treeline
