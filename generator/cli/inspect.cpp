#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cli/commands.hpp"
#include "cli/read_robot_files.hpp"
#include "description/noise.hpp"
#include "description/scene_queries.hpp"
#include "generation/measure_savings.hpp"
#include "inspect/inspect_robot.hpp"
#include "inspect/print_tables.hpp"
#include "inspect/warn_of_limits.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/leave_out_singular.hpp"
#include "terminal/exit_code.hpp"
#include "terminal/print_diagnostics.hpp"
#include "terminal/write_output.hpp"
#include "text/read_text_file.hpp"

namespace treeline {
namespace {

struct InspectOptions {
  std::string urdf, scene;
  std::string repair;  ///< file to write the repaired URDF to; empty: none
  bool json = false, dot = false, savings = false, summary = false, noise = false;
  bool base_parameters = false;
  Warnings warnings = Warnings::summary;
};

struct Inspection {
  std::string text;  ///< of the URDF; empty for several robots
  Robot robot;
  Report report;
};

/// The scene that is named, or the default one, without what the robot's masses do not permit: what
/// `generate` refuses is no more than a warning here.
std::optional<Scene> read_scene_of(const RobotWithFiles& read, Diagnostics& diagnostics) {
  auto scene = parse_scene_of(read, diagnostics);
  if (!scene) return std::nullopt;
  Diagnostics left_out;
  leave_out_singular(read.robot, *scene, place_of_list(read.files, {}), left_out);
  for (Diagnostic each : left_out.list()) {
    each.severity = Severity::warning;
    diagnostics.add(std::move(each));
  }
  return scene;
}

std::optional<Inspection> inspect(const InspectOptions& options, Diagnostics& diagnostics) {
  auto read = read_robot_files(options.urdf, options.scene, diagnostics);
  if (!read) return std::nullopt;
  std::optional<Scene> scene;
  if (!read->files.scene.empty()) {
    scene = read_scene_of(*read, diagnostics);
    if (!scene) return std::nullopt;
    scene->inputs = {};  // the robot as it is in the files
  }
  const Scene seen = scene.value_or(Scene{});
  note_noise(build_mechanism(read->robot, seen).noise, seen, diagnostics);
  warn_of_limits(read->robot, seen, LimitUse::code, diagnostics);
  Report report = inspect_robot(read->robot, scene);
  return Inspection{std::move(read->files.urdf_text), std::move(read->robot), std::move(report)};
}

/// Prints which functions the scene leaves out of all that could be emitted for it.
int run_savings(const InspectOptions& options) {
  Diagnostics diagnostics;
  const auto read = read_robot_files(options.urdf, options.scene, diagnostics);
  const auto scene = read ? read_scene_of(*read, diagnostics) : std::nullopt;
  print_diagnostics(diagnostics, options.warnings);
  if (!scene) {
    return kBadInput;
  }
  const Savings savings = measure_savings(read->robot, *scene);
  return write_output(fmt::format("{}\n{}", print_functions(savings), print_table({savings})),
                      OutputForm::text, kOk);
}

/// Whether all is written; else with an error.
bool write_repaired(const InspectOptions& options, const std::string& text, std::size_t repairs,
                    Diagnostics& diagnostics) {
  if (!write_output_file(options.repair, text, diagnostics, {options.urdf, options.scene})) {
    return false;
  }
  diagnostics.add({Severity::note, options.repair, 0, "",
                   repairs == 0 ? "nothing needed repair: this is the URDF as it was"
                                : fmt::format("the URDF is written with the inertias of {} "
                                              "link{} repaired",
                                              repairs, repairs == 1 ? "" : "s"),
                   ""});
  return true;
}

/// Several robots have no text of their own to repair: an error where that is asked for.
std::optional<std::string> repair_none(const InspectOptions& options, Diagnostics& diagnostics) {
  if (options.repair.empty()) return std::string();
  diagnostics.add({Severity::error, shown_path(options.urdf), 0, "--repair",
                   "the scene lists several robots", "repair each robot's URDF by itself"});
  return std::nullopt;
}

/// The patch that repairs the inertias, written to the file as well where one is asked for.
std::optional<std::string> repair(const InspectOptions& options, const Inspection& inspection,
                                  Diagnostics& diagnostics) {
  if (!inspection.robot.parts.empty()) return repair_none(options, diagnostics);
  const auto repairs = list_repairs(inspection.robot, inspection.report);
  const auto edits = edit_inertias(inspection.robot, inspection.text, repairs);
  const std::string repaired = apply_edits(inspection.text, edits);
  if (!has_repairs(repaired, inspection.robot, repairs)) {
    diagnostics.add({Severity::error, shown_path(options.urdf), 0, "",
                     "the places of its inertias were not found in the text: nothing is repaired",
                     "report this file: its XML is read in two ways that differ"});
    return std::nullopt;
  }
  if (!options.repair.empty() && !write_repaired(options, repaired, repairs.size(), diagnostics)) {
    return std::nullopt;
  }
  return print_patch(options.urdf, inspection.text, edits);
}

/// Prints the output of `print` for the robot in the scene, if one is given.
int run_print(const InspectOptions& options, std::string (*print)(const Robot&, const Scene&),
              OutputForm form = OutputForm::text) {
  Diagnostics diagnostics;
  const auto read = read_robot_files(options.urdf, options.scene, diagnostics);
  std::optional<Scene> scene = Scene{};
  if (read && !read->files.scene.empty()) scene = read_scene_of(*read, diagnostics);
  print_diagnostics(diagnostics, options.warnings);
  if (!read || !scene) {
    return kBadInput;
  }
  return write_output(print(read->robot, *scene), form, kOk);
}

int run(const InspectOptions& options) {
  if (options.savings) {
    return run_savings(options);
  }
  if (options.noise) {
    return run_print(options, print_noise);
  }
  if (options.base_parameters) {
    return options.json ? run_print(options, print_base_parameters_json, OutputForm::json)
                        : run_print(options, print_base_parameters);
  }
  Diagnostics diagnostics;
  const auto inspection = inspect(options, diagnostics);
  const auto patch =
      inspection ? repair(options, *inspection, diagnostics) : std::optional<std::string>();
  print_diagnostics(diagnostics, options.warnings);
  if (!patch) {
    return kBadInput;
  }
  const Report& report = inspection->report;
  if (options.json) return write_output(print_json(report), OutputForm::json, kOk);
  if (options.dot) return write_output(print_dot(report), OutputForm::text, kOk);
  if (options.summary) return write_output(print_summary(report), OutputForm::text, kOk);
  const std::string text = print_text(report);
  return write_output(patch->empty() ? text : text + "\n" + *patch, OutputForm::text, kOk);
}

}  // namespace

void add_inspect(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<InspectOptions>();
  CLI::App* command = app.add_subcommand(
      "inspect", "Tell what a URDF holds: tree, joints, masses, reductions, conditioning");
  command->add_option("urdf", options->urdf, kRobotArgument)->required();
  command->add_option("scene", options->scene, "Base, locked joints, operational points; YAML");
  auto* json = command->add_flag("--json", options->json, "The report as JSON");
  auto* dot = command->add_flag("--dot", options->dot, "The tree for Graphviz")->excludes(json);
  auto* summary =
      command->add_flag("--summary", options->summary, "The first lines alone")->excludes(json);
  auto* savings =
      command
          ->add_flag("--savings", options->savings,
                     "What the scene leaves out: functions, operations and bytes of code")
          ->excludes(json);
  add_warnings_option(*command, options->warnings);
  auto* noise =
      command
          ->add_flag("--noise", options->noise,
                     "Each number that is taken as exact because it differs by less than rounding")
          ->excludes(json);
  auto* base_parameters = command->add_flag(
      "--base-parameters", options->base_parameters,
      "The combinations of inertial parameters on which the motion depends; with --json for "
      "programs");
  auto* repair = command->add_option(
      "--repair", options->repair,
      "Write the URDF to this file with inertias that no body has, and that the motion feels, "
      "replaced by the nearest possible ones");
  summary->excludes(dot);
  for (auto* other : {savings, noise, base_parameters}) {  // which print something else
    other->excludes(dot)->excludes(summary)->excludes(repair);
  }
  savings->excludes(noise)->excludes(base_parameters);
  noise->excludes(base_parameters);
  command->footer(
      "Examples:\n"
      "  treeline inspect puma560.urdf\n"
      "  treeline inspect puma560.urdf scene.yaml --json\n"
      "  treeline inspect puma560.urdf scene.yaml --savings\n"
      "  treeline inspect puma560.urdf scene.yaml --base-parameters --json\n"
      "  treeline inspect robot.urdf --repair repaired.urdf\n"
      "  treeline inspect puma560.urdf --dot | dot -Tsvg > tree.svg");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace treeline
