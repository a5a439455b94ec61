#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "cli/commands.hpp"
#include "description/read_robot_text.hpp"
#include "description/read_scene.hpp"
#include "description/scene_queries.hpp"
#include "drawing/read_visuals.hpp"
#include "generation/quote_for_shell.hpp"
#include "inspect/propose_scene.hpp"
#include "terminal/exit_code.hpp"
#include "terminal/option_values.hpp"
#include "terminal/print_diagnostics.hpp"
#include "terminal/write_output.hpp"
#include "text/read_text_file.hpp"

namespace treeline {
namespace {

struct InitOptions {
  std::string urdf, base, output;
  bool to_file = false, force = false;
  Warnings warnings = Warnings::summary;
};

std::optional<Base> base_asked_for(const InitOptions& options) {
  if (options.base.empty()) return std::nullopt;
  return options.base == "floating" ? Base::floating : Base::fixed;
}

/// Whether a ball is the end of a cylinder, as text of a URDF has capsules.
bool ends_a_cylinder(const Visual& ball, const std::vector<Visual>& shapes) {
  return std::any_of(shapes.begin(), shapes.end(), [&](const Visual& cylinder) {
    if (cylinder.kind != VisualKind::cylinder || cylinder.link != ball.link) return false;
    const double apart = (cylinder.pose.translation() - ball.pose.translation()).norm();
    return cylinder.size.x() == ball.size.x() && std::abs(apart - cylinder.size.y() / 2) < 1e-6;
  });
}

std::vector<TouchShape> find_touch_shapes(const std::string& urdf) {
  Diagnostics ignored;  // nothing is drawn
  const std::vector<Visual> shapes = read_collisions(urdf, "", ignored);
  std::vector<TouchShape> found;
  for (const Visual& shape : shapes) {
    const bool is_ball = shape.kind == VisualKind::sphere && !ends_a_cylinder(shape, shapes);
    if (!is_ball && shape.kind != VisualKind::box) continue;
    found.push_back({shape.link, shape.pose, is_ball ? Eigen::Vector3d::Zero() : shape.size,
                     is_ball ? shape.size.x() : 0});
  }
  return found;
}

/// Whether anything moves on the proposed base; else with an error, which is about the robot: there
/// is no scene yet whose line could be at fault.
bool can_move(const Robot& robot, const InitOptions& options, const SceneProposal& proposal,
              Diagnostics& diagnostics) {
  Scene scene;
  scene.base = proposal.base;
  if (count(find_freedoms(robot, scene)) > 0) return true;
  diagnostics.add({Severity::error, shown_path(options.urdf), 0, "",
                   "nothing moves: the robot has no joint that moves, and its base is fixed",
                   options.base.empty() ? "give its links mass, so that the base can float"
                                        : "leave out --base fixed, so that the base floats"});
  return false;
}

/// The text, which is read again as any scene is: for the functions that it permits, and so that
/// nothing is proposed that would be refused.
std::optional<std::string> make_scene(const InitOptions& options, Diagnostics& diagnostics) {
  const auto robot_text = read_robot_text(options.urdf, diagnostics);
  if (!robot_text) return std::nullopt;
  const auto robot = parse_robot(*robot_text, diagnostics);
  if (!robot) return std::nullopt;
  const SceneProposal proposal =
      propose_scene(*robot, base_asked_for(options), find_touch_shapes(robot_text->urdf));
  if (!can_move(*robot, options, proposal, diagnostics)) return std::nullopt;
  const std::string file = quote_for_shell(std::filesystem::path(options.urdf).filename().string());
  const auto scene = parse_scene(print_scene(*robot, proposal, file, {}),
                                 options.to_file ? options.output : "scene", *robot, diagnostics);
  if (!scene) return std::nullopt;
  return print_scene(*robot, proposal, file, scene->functions);
}

/// A scene that somebody has worked on is not overwritten.
bool may_write(const InitOptions& options, Diagnostics& diagnostics) {
  std::error_code ignored;
  if (options.force || !std::filesystem::exists(options.output, ignored)) return true;
  diagnostics.add({Severity::error, options.output, 0, "", "the file is there already",
                   "name another one, or add --force to overwrite it"});
  return false;
}

int run(const InitOptions& options) {
  Diagnostics diagnostics;
  const auto text = make_scene(options, diagnostics);
  const bool written = text && options.to_file && may_write(options, diagnostics) &&
                       write_output_file(options.output, *text, diagnostics, {options.urdf});
  print_diagnostics(diagnostics, options.warnings);
  if (!text || options.to_file) return written ? kOk : kBadInput;
  return write_output(*text, OutputForm::text, kOk);
}

}  // namespace

void add_init_scene(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<InitOptions>();
  CLI::App* command =
      app.add_subcommand("init-scene", "Propose a scene for a robot, with comments, to start from");
  command->add_option("urdf", options->urdf, "Robot, URDF, SDF or MJCF")->required();
  auto* output =
      command->add_option("-o,--output", options->output, "File to write, else standard output")
          ->check(no_equals_sign());
  command->add_option("--base", options->base, "fixed or floating, instead of the guess")
      ->check(one_of({"fixed", "floating"}));
  command->add_flag("--force", options->force, "Overwrite the file");
  add_warnings_option(*command, options->warnings);
  command->footer(
      "Examples:\n"
      "  treeline init-scene puma560.urdf\n"
      "  treeline init-scene puma560.urdf -o scene.yaml\n"
      "  treeline init-scene anymal.urdf --base floating | tee anymal.yaml\n"
      "A scene for several robots lists them under the key robots: treeline keys robots.");
  command->callback([options, output, &exit_code] {
    options->to_file = !output->empty() && options->output != "-";
    exit_code = run(*options);
  });
}

}  // namespace treeline
