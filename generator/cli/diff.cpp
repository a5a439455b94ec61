#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "comparison/difference.hpp"
#include "description/read_urdf.hpp"
#include "description/scene_queries.hpp"
#include "terminal/exit_code.hpp"
#include "terminal/option_values.hpp"
#include "terminal/print_diagnostics.hpp"
#include "terminal/write_output.hpp"

namespace treeline {
namespace {

struct DiffOptions {
  std::string first, second;
  std::string base;  ///< empty: fixed, or floating where nothing else moves
  double tolerance = 1e-6;
  bool json = false;
  Warnings warnings = Warnings::summary;
};

Base choose_base(const DiffOptions& options, const Robot& first) {
  if (!options.base.empty()) return options.base == "floating" ? Base::floating : Base::fixed;
  return find_freedoms(first, Scene{}).empty() ? Base::floating : Base::fixed;
}

int run(const DiffOptions& options) {
  Diagnostics diagnostics;
  if (options.first == "-" && options.second == "-") {
    diagnostics.add({Severity::error, "standard input", 0, "", "both robots are to come from it",
                     "write one of the two into a file"});
    print_diagnostics(diagnostics);
    return kBadInput;
  }
  const auto first = read_urdf(options.first, diagnostics);
  const auto second = read_urdf(options.second, diagnostics);
  print_diagnostics(diagnostics, options.warnings);
  if (!first || !second) {
    return kBadInput;
  }
  const RobotDifference difference =
      compare_robots(*first, *second, choose_base(options, *first), options.tolerance);
  const ExitCode exit_code = difference.differs() ? kMismatch : kOk;
  return options.json ? write_output(print_json(difference), OutputForm::json, exit_code)
                      : write_output(print_text(difference), OutputForm::text, exit_code);
}

}  // namespace

void add_diff(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<DiffOptions>();
  CLI::App* command = app.add_subcommand(
      "diff", "Tell by how much two robots differ: poses, masses, limits, dynamics");
  command->add_option("first", options->first, "Robot, URDF, SDF or MJCF")->required();
  command->add_option("second", options->second, "The other robot, URDF, SDF or MJCF")->required();
  command
      ->add_option("--tolerance", options->tolerance,
                   "What counts as the same: m, rad, and relative to masses, inertias, forces")
      ->check(between(0, 1e12))
      ->capture_default_str();
  command
      ->add_option("--base", options->base,
                   "Of the dynamics; without it fixed, or floating where nothing else moves")
      ->check(one_of({"fixed", "floating"}));
  command->add_flag("--json", options->json, "The differences as JSON");
  add_warnings_option(*command, options->warnings);
  command->footer(
      "Links and joints are matched by name, the rest by its place in the tree.\n"
      "Exit: 0 the same, 3 different.\n"
      "Examples:\n"
      "  treeline diff iiwa14_ros.urdf iiwa14_drake.urdf\n"
      "  treeline diff a.urdf b.urdf --tolerance 1e-3 --base floating --json");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace treeline
