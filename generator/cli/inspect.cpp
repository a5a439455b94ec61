#include "cli/inspect.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

#include "cli/exit_code.hpp"
#include "cli/read_inputs.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "generation/measure_savings.hpp"
#include "inspect/inspect_robot.hpp"

namespace treeline {
namespace {

struct InspectOptions {
  std::string urdf, scene;
  bool json = false, dot = false, savings = false;
};

std::optional<Report> inspect(const InspectOptions& options, Diagnostics& diagnostics) {
  const auto robot = read_urdf(options.urdf, diagnostics);
  if (!robot) {
    return std::nullopt;
  }
  std::optional<Scene> scene;
  if (!options.scene.empty()) {
    scene = read_scene(options.scene, *robot, diagnostics);
    if (!scene) {
      return std::nullopt;
    }
  }
  return inspect_robot(*robot, scene);
}

/// What the scene leaves out of all that could be emitted for it.
int run_savings(const InspectOptions& options) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(options.urdf, diagnostics);
  std::optional<Scene> scene;
  if (robot) scene = read_scene(options.scene, *robot, diagnostics);
  print_diagnostics(diagnostics);
  if (!scene) {
    return kBadInput;
  }
  const Savings savings = measure_savings(*robot, *scene);
  fmt::print("{}\n{}", print_functions(savings), print_table({savings}));
  return kOk;
}

int run(const InspectOptions& options) {
  if (options.savings) {
    return run_savings(options);
  }
  Diagnostics diagnostics;
  const auto report = inspect(options, diagnostics);
  print_diagnostics(diagnostics);
  if (!report) {
    return kBadInput;
  }
  fmt::print("{}", options.json  ? print_json(*report)
                   : options.dot ? print_dot(*report)
                                 : print_text(*report));
  return kOk;
}

}  // namespace

void add_inspect(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<InspectOptions>();
  CLI::App* command = app.add_subcommand(
      "inspect", "Tell what a URDF holds: tree, joints, masses, reductions, conditioning");
  command->add_option("urdf", options->urdf, "Robot, URDF")->required();
  auto* scene =
      command->add_option("scene", options->scene, "Base, locked joints, operational points; YAML");
  auto* json = command->add_flag("--json", options->json, "The report as JSON");
  command->add_flag("--dot", options->dot, "The tree for Graphviz")->excludes(json);
  command
      ->add_flag("--savings", options->savings,
                 "What the scene leaves out: functions, operations and bytes of code")
      ->needs(scene)
      ->excludes(json);
  command->footer(
      "Examples:\n"
      "  treeline inspect puma560.urdf\n"
      "  treeline inspect puma560.urdf scene.yaml --json\n"
      "  treeline inspect puma560.urdf scene.yaml --savings\n"
      "  treeline inspect puma560.urdf --dot | dot -Tsvg > tree.svg");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace treeline
