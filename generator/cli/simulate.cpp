#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/commands.hpp"
#include "cli/find_all_meshes.hpp"
#include "cli/read_robot_files.hpp"
#include "cli/simulate_motion.hpp"
#include "cli/simulated_scene.hpp"
#include "description/read_surroundings.hpp"
#include "oracle/leave_out_singular.hpp"
#include "terminal/exit_code.hpp"
#include "terminal/option_values.hpp"
#include "terminal/print_diagnostics.hpp"
#include "terminal/write_output.hpp"
#include "text/json_text.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

struct SimulateOptions {
  std::string urdf, scene;
  MotionSettings motion;
  bool ground = false;
  MeshOptions meshes;
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

std::string print_ground(const simulation::GroundAccount& ground) {
  std::string text = fmt::format(
      "  contacts               at most {} at once, {} bounces, deepest {:.1e} m\n"
      "  impulse of the ground  {:.6g} N s up, {:.6g} and {:.6g} N s along x and y\n",
      ground.most_contacts, ground.bounces, ground.deepest, ground.impulse.z(), ground.impulse.x(),
      ground.impulse.y());
  if (ground.left_out > 0) {
    text += fmt::format("  left out               points in the ground beyond {}, in {} steps\n",
                        simulation::kMostGroundContacts, ground.left_out);
  }
  if (ground.unconverged > 0) {
    text += fmt::format(
        "  not converged          {} blows: friction or restitution are not exact there\n",
        ground.unconverged);
  }
  return text;
}

/// What the change of the energy at the end consists of.
std::string print_parts(const Motion& motion) {
  std::string parts;
  if (motion.has_joint_forces) {
    parts += fmt::format("joint forces and friction {:.3e} J, ", motion.joint_work);
  }
  if (motion.has_contacts) {
    parts += fmt::format("{} {:.3e} J, ", motion.ground ? "contacts and stops" : "stops",
                         motion.contact_energy);
  }
  if (parts.empty()) return ", the integrator's error";
  return fmt::format(": {}the integrator's error {:.3e} J", parts, motion.integrator_error());
}

std::string print_text(const std::string& robot, const Motion& motion) {
  std::string text = fmt::format(
      "{}: {:g} s, {} rows\n"
      "  energy at the start    {:.6g} J\n"
      "  change at the end      {:.3e} J{}\n"
      "  largest change         {:.3e} J\n",
      robot, last_time(motion), motion.table.rows(), motion.start_energy, motion.energy_change,
      print_parts(motion), motion.largest_change);
  if (motion.ground) text += print_ground(*motion.ground);
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
  nlohmann::ordered_json json = {{"robot", robot},
                                 {"seconds", last_time(motion)},
                                 {"rows", motion.table.rows()},
                                 {"given_up", gave_up(motion)},
                                 {"start_energy", motion.start_energy},
                                 {"energy_change", motion.energy_change},
                                 {"joint_work", motion.joint_work},
                                 {"contact_energy", motion.contact_energy},
                                 {"integrator_error", motion.integrator_error()},
                                 {"largest_change", motion.largest_change},
                                 {"quaternion_error", motion.quaternion_error},
                                 {"adaptive_steps", motion.adaptive_steps},
                                 {"rejected_steps", motion.rejected_steps}};
  if (motion.ground) {
    const simulation::GroundAccount& ground = *motion.ground;
    json["ground"] = {{"energy", motion.contact_energy},
                      {"impulse", {ground.impulse.x(), ground.impulse.y(), ground.impulse.z()}},
                      {"most_contacts", ground.most_contacts},
                      {"bounces", ground.bounces},
                      {"deepest", ground.deepest},
                      {"steps_with_points_left_out", ground.left_out},
                      {"unconverged", ground.unconverged}};
  }
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
  const std::string summary = options.json ? print_json(robot, motion) : print_text(robot, motion);
  const OutputForm form = options.json ? OutputForm::json : OutputForm::text;
  if (options.csv != "-") return write_output(summary, form, exit_code);
  print_message(printable_lines(summary));
  return write_output(report::csv_text(motion.table), OutputForm::text, exit_code);
}

/// The ground of the scene, or the default one of `--ground`, with what may touch it.
std::optional<GroundOfRobot> read_ground_of(const SimulateOptions& options,
                                            const RobotWithFiles& read,
                                            std::optional<SceneGround> law,
                                            Diagnostics& diagnostics) {
  if (options.ground && !law) law.emplace();
  if (!law && options.motion.height) {
    diagnostics.add({Severity::error, "", 0, "--height", "there is no ground to be above",
                     "give --ground, or the key `ground` in the scene"});
  }
  const auto places = read_mesh_places(options.meshes, diagnostics);
  if (!law || !places) return std::nullopt;
  return GroundOfRobot{*law, read_ground_shapes(read.files, *places, diagnostics)};
}

int simulate(const SimulateOptions& options, Diagnostics& diagnostics) {
  const auto read = read_robot_files(options.urdf, options.scene, diagnostics);
  const auto scene = read ? parse_scene_of(*read, diagnostics) : std::nullopt;
  if (!scene) return kBadInput;
  refuse_unheld(read->robot, *scene, diagnostics);
  if (diagnostics.has_errors() || !has_accelerations(read->robot, *scene, diagnostics)) {
    return kBadInput;
  }
  const SceneSurroundings around = surroundings_of(read->files.scene_text, read->robot);
  note_unsimulated(*scene, around, options.motion.has_joint_forces(), diagnostics);
  const auto ground = read_ground_of(options, *read, around.ground, diagnostics);
  for (const std::string& file : {options.csv, options.svg}) {
    (void)may_write(file, list_paths(read->files), diagnostics);
  }
  if (diagnostics.has_errors()) return kBadInput;
  const auto motion = simulate_motion(read->robot, *scene, options.motion, ground, diagnostics);
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
  command
      .add_option("--stiffness", motion.stiffness,
                  "Joint force per displacement from the start, as far as --step permits; of "
                  "quaternions the rotation vector counts")
      ->check(between(0, 1e12));
}

}  // namespace

void add_simulate(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* command =
      app.add_subcommand("simulate", "Let a robot go, and tell what became of its energy");
  command->add_option("urdf", options->urdf, kRobotArgument)->required();
  command->add_option("scene", options->scene,
                      "Base, gravity, ground, locked joints, what is in joints; YAML");
  add_motion_options(*command, options->motion);
  command->add_flag("--stops", options->motion.stops,
                    "Joints stop at the limits of their file, without bouncing");
  command->add_flag("--ground", options->ground,
                    "Ground z < 0 that the shapes of <collision> touch, also where the scene has "
                    "no key `ground`");
  command
      ->add_option("--height", options->motion.height,
                   "Of a floating robot's lowest point over the ground at the start, m")
      ->check(between(0, 1e6));
  add_mesh_options(*command, options->meshes);
  command
      ->add_option("--csv", options->csv,
                   "Table of time, q, qd, energy, contacts; - is standard output")
      ->check(no_input_file());
  command->add_option("--svg", options->svg, "The same drawn")->check(no_input_file());
  command->add_flag("--json", options->json, "Summary as JSON");
  add_warnings_option(*command, options->warnings);
  command->footer(
      "Exit: 3 when the motion had to be given up.\n"
      "Examples:\n"
      "  treeline simulate puma560.urdf --seconds 2 --svg swing.svg\n"
      "  treeline simulate humanoid24.urdf scene_floating.yaml --integrator adaptive --json\n"
      "  treeline simulate humanoid24.urdf scene_floating.yaml --ground --height 0.5 --csv "
      "fall.csv\n"
      "  treeline simulate planar3r.urdf --q 0,1,0 --qd 1,0,-1 --hold --csv - | head");
  command->callback([options, &exit_code] {
    Diagnostics diagnostics;
    exit_code = simulate(*options, diagnostics);
    print_diagnostics(diagnostics, options->warnings);
  });
}

}  // namespace treeline
