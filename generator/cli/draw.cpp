#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <memory>

#include "cli/choose_moments.hpp"
#include "cli/commands.hpp"
#include "drawing/scene_solids.hpp"
#include "launch/split_ball_joints.hpp"
#include "terminal/exit_code.hpp"
#include "terminal/option_values.hpp"
#include "terminal/print_diagnostics.hpp"
#include "terminal/write_output.hpp"
#include "text/suggest_name.hpp"

namespace treeline {
namespace {

struct DrawOptions {
  std::string urdf, scene, output;
  MomentOptions moments;
  MeshOptions meshes;
  View view;
  Warnings warnings = Warnings::summary;
};

/// In a record of `treeline drive` ball joints are the hinges that were driven.
void split_if_driven(const DrawOptions& options, DrawnRobot& drawn) {
  std::ifstream motion(options.moments.motion);
  if (options.moments.motion.empty() || motion.peek() != '{') return;
  Diagnostics said_while_driven;
  split_ball_joints(drawn.robot, drawn.scene, said_while_driven);
}

/// So many triangles that a file stays below some 300 kB: of each, half are seen.
std::size_t most_triangles(const MomentOptions& options) {
  constexpr std::size_t kOfFile = 12000, kOfPicture = 6000, kLeast = 300;
  const std::size_t pictures = options.animate          ? kOfFile / kLeast
                               : options.motion.empty() ? 1
                               : !options.times.empty()
                                   ? options.times.size()
                                   : static_cast<std::size_t>(options.pictures);
  return std::clamp(kOfFile / pictures, kLeast, kOfPicture);
}

/// Forges show pictures in pages, which people load by telephone too.
void note_size(const std::string& svg, Diagnostics& diagnostics) {
  constexpr std::size_t kLarge = 400'000;  // bytes
  if (svg.size() <= kLarge) return;
  diagnostics.add({Severity::note, "", 0, "",
                   fmt::format("the animation has {} kB", svg.size() / 1000),
                   "fewer frames make it smaller: --fps, --seconds or --times FIRST,LAST"});
}

/// Whether a robot has a link, or none is named; else with an error.
bool has_link(const Robot& robot, const std::string& name, Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const Link& link : robot.links) names.push_back(link.name);
  if (name.empty() || std::ranges::find(names, name) != names.end()) return true;
  diagnostics.add({Severity::error, robot.file, 0, "--close-up",
                   fmt::format("there is no link `{}`", name), suggest_name(name, names)});
  return false;
}

ExitCode draw(const DrawOptions& options, Diagnostics& diagnostics) {
  const MomentOptions& wanted = options.moments;
  if (wanted.animate && wanted.motion.empty() && wanted.to.empty()) {
    diagnostics.add({Severity::error, "", 0, "--animate", "there is no motion to show",
                     "Give a motion by --motion FILE, or a state to move to by --to Q."});
    return kUsage;
  }
  const auto places = read_mesh_places(options.meshes, diagnostics);
  auto drawn = places ? read_drawn_robot(options.urdf, options.scene, *places,
                                         most_triangles(wanted), diagnostics)
                      : std::nullopt;
  if (!drawn) return kBadInput;
  drawn->files.push_back(wanted.motion);
  if (!may_write(options.output, drawn->files, diagnostics)) return kBadInput;
  split_if_driven(options, *drawn);
  const LinkPlacer placer(drawn->robot, drawn->scene);
  if (!has_link(drawn->robot, options.view.close_up, diagnostics)) return kBadInput;
  const auto moments = choose_moments(wanted, *drawn, placer, diagnostics);
  if (!moments) return kBadInput;
  const Solids standing = obstacle_solids(drawn->surroundings.obstacles);
  const std::string svg =
      wanted.animate
          ? animate_robot(drawn->robot, placer, drawn->visuals, *moments, options.view, wanted.film,
                          standing)
          : draw_robot(drawn->robot, placer, drawn->visuals, *moments, options.view, standing);
  if (wanted.animate) note_size(svg, diagnostics);
  if (options.output.empty() || options.output == "-") {
    return write_output(svg, OutputForm::text, kOk);
  }
  return write_output_file(options.output, svg, diagnostics, drawn->files) ? kOk : kBadInput;
}

void add_motion_options(CLI::App& command, MomentOptions& options) {
  auto* q =
      command.add_option("--q", options.q, "Where it stands, separated by commas; else at rest")
          ->delimiter(',')
          ->check(any_number());
  auto* motion = command
                     .add_option("--motion", options.motion,
                                 "Draw a motion: table of simulate --csv or of an experiment, "
                                 "or record of drive")
                     ->excludes(q);
  auto* times =
      command
          .add_option("--times", options.times, "s, a picture each; of an animation: first,last")
          ->delimiter(',')
          ->check(any_number())
          ->needs(motion);
  auto* pictures = command.add_option("--pictures", options.pictures, "So many, evenly spread")
                       ->check(whole_between(1, 100))
                       ->capture_default_str()
                       ->excludes(times);
  command.add_option("--path", options.paths, "Operational points or links whose paths are drawn")
      ->delimiter(',')
      ->needs(motion);
  auto* animate = command
                      .add_flag("--animate", options.animate,
                                "Draw one picture that moves, over and over, as SVG with CSS")
                      ->excludes(pictures);
  command
      .add_option("--to", options.to,
                  "Animate from --q to this state and back, in 4 s or in --seconds")
      ->delimiter(',')
      ->check(any_number())
      ->needs(animate)
      ->excludes(motion);
  command.add_option("--seconds", options.seconds, "Of the animated motion; else as recorded")
      ->check(between(0.1, 600))
      ->needs(animate);
  command.add_option("--fps", options.film.rate, "Pictures a second")
      ->check(between(1, 60))
      ->capture_default_str()
      ->needs(animate);
  command.add_option("--pause", options.film.pause, "Rest on the last picture, s")
      ->check(between(0.02, 60))
      ->capture_default_str()
      ->needs(animate);
}

void add_options(CLI::App& command, DrawOptions& options) {
  command.add_option("urdf", options.urdf, kRobotArgument)->required();
  command.add_option("scene", options.scene, "Base, locked joints, points; YAML");
  add_motion_options(command, options.moments);
  command.add_option("--azimuth", options.view.azimuth, "Of the camera about z, rad")
      ->check(any_number())
      ->capture_default_str();
  command.add_option("--elevation", options.view.elevation, "Of the camera over the ground, rad")
      ->check(any_number())
      ->capture_default_str();
  command.add_option("--width", options.view.width, "Of one picture, pixels")
      ->check(between(60, 4000))
      ->capture_default_str();
  command.add_option("--close-up", options.view.close_up,
                     "Link whose neighbourhood is shown, not all of the robot");
  add_mesh_options(command, options.meshes);
  command.add_option("-o,--output,--svg", options.output, "File to write, else standard output")
      ->check(no_equals_sign())
      ->check(no_input_file());
  add_warnings_option(command, options.warnings);
}

}  // namespace

void add_draw(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<DrawOptions>();
  CLI::App* command = app.add_subcommand(
      "draw", "Draw a robot, moments of its motion side by side, or an animation, as SVG");
  add_options(*command, *options);
  command->footer(
      "Boxes, cylinders, spheres and meshes (STL, OBJ, DAE) of the URDF are drawn. Where no mesh "
      "of\n"
      "a link can be read, the shapes by which it collides are, or rods if there are none.\n"
      "Examples:\n"
      "  treeline draw puma560.urdf --q 0,-0.7,0.7,0,0.5,0 -o puma.svg\n"
      "  treeline draw puma560.urdf --animate --to 1,-0.7,0.7,0,0.5,0 -o turn.svg\n"
      "  treeline simulate planar3r.urdf --csv swing.csv\n"
      "  treeline draw planar3r.urdf --motion swing.csv --pictures 6 -o swing.svg\n"
      "  treeline draw planar3r.urdf --motion swing.csv --animate -o moving.svg\n"
      "  treeline draw arm.urdf scene.yaml --motion record.jsonl --path tool -o strip.svg");
  command->callback([options, &exit_code] {
    Diagnostics diagnostics;
    exit_code = draw(*options, diagnostics);
    print_diagnostics(diagnostics, options->warnings);
  });
}

}  // namespace treeline
