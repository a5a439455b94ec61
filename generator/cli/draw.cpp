#include "cli/draw.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>

#include "cli/exit_code.hpp"
#include "cli/option_values.hpp"
#include "cli/print_diagnostics.hpp"
#include "cli/read_robot_files.hpp"
#include "cli/write_output.hpp"
#include "description/read_surroundings.hpp"
#include "drawing/draw_robot.hpp"
#include "drawing/recorded_motion.hpp"
#include "drawing/scene_solids.hpp"
#include "launch/split_ball_joints.hpp"
#include "text/read_text_file.hpp"
#include "text/suggest_name.hpp"

namespace treeline {
namespace {

struct DrawOptions {
  std::string urdf, scene, motion, path, svg;
  std::vector<double> q, times;
  int pictures = 5;
  View view;
  Warnings warnings = Warnings::summary;
};

/// Content of the picture, read from the files.
struct Drawn {
  Robot robot;
  Scene scene;
  std::vector<Visual> visuals;
  SceneSurroundings surroundings;
  std::vector<std::string> files;  ///< that all this was read from
};

/// The shapes of all robots, those of several named as `join_robots` names their links.
std::vector<Visual> read_all_visuals(const RobotFiles& files, Diagnostics& diagnostics) {
  if (!files.urdf.empty()) {
    return read_visuals(files.urdf_text, shown_path(files.urdf), diagnostics);
  }
  const SceneRobots& listed = files.scene_robots;
  std::vector<std::vector<Visual>> of_files;
  for (const InputFile& file : listed.files) {
    of_files.push_back(read_visuals(file.text, file.path, diagnostics));
  }
  std::vector<Visual> visuals;
  for (std::size_t i = 0; i < listed.robots.size(); ++i) {
    for (Visual visual : of_files[listed.file_of_robot[i]]) {
      visual.link.insert(0, listed.robots[i].name + "/");
      visuals.push_back(std::move(visual));
    }
  }
  return visuals;
}

std::optional<Drawn> read_files(const DrawOptions& options, Diagnostics& diagnostics) {
  Diagnostics own;
  auto read = read_robot_files(options.urdf, options.scene, own);
  auto scene = read ? parse_scene_of(*read, own) : std::nullopt;
  // What is worth a warning about dynamics is not about a picture.
  for (const Diagnostic& diagnostic : own.list()) {
    if (diagnostic.severity == Severity::error) diagnostics.add(diagnostic);
  }
  if (!scene) return std::nullopt;
  const std::string file = read->robot.file;
  auto visuals = read_all_visuals(read->files, diagnostics);
  const auto meshes = std::count_if(visuals.begin(), visuals.end(), [](const Visual& visual) {
    return visual.kind == VisualKind::mesh;
  });
  if (meshes > 0) {
    diagnostics.add({Severity::note, file, 0, "",
                     fmt::format("{} not drawn: rods stand for links without another shape",
                                 meshes == 1 ? "1 mesh is" : fmt::format("{} meshes are", meshes)),
                     "`treeline drive` shows meshes in a browser."});
  }
  auto surroundings = surroundings_of(read->files.scene_text, read->robot);
  return Drawn{std::move(read->robot), std::move(*scene), std::move(visuals),
               std::move(surroundings), list_paths(read->files)};
}

/// In a record of `treeline drive` ball joints are the hinges that were driven.
void split_if_driven(const DrawOptions& options, Drawn& drawn) {
  std::ifstream motion(options.motion);
  if (options.motion.empty() || motion.peek() != '{') return;
  Diagnostics said_while_driven;
  split_ball_joints(drawn.robot, drawn.scene, said_while_driven);
}

/// Index of the point whose path is drawn; nothing, with an error, if the scene has none such.
std::optional<std::size_t> find_point(const Drawn& drawn, const std::string& name,
                                      Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const ScenePoint& point : drawn.scene.operational_points) {
    if (point.name == name) return names.size();
    names.push_back(point.name);
  }
  diagnostics.add(
      {Severity::error, drawn.scene.file, 0, "--path",
       fmt::format("there is no operational point `{}`", name),
       names.empty() ? "Give a scene that has `operational_points`." : suggest_name(name, names)});
  return std::nullopt;
}

/// The row of a motion that is nearest before a time, or at it.
std::size_t row_at(const RecordedMotion& motion, double time) {
  constexpr double kSlack = 1e-9;  // s, of times that were rounded in the file
  const auto after = std::upper_bound(motion.times.begin(), motion.times.end(), time + kSlack);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - motion.times.begin() - 1));
}

/// The times of the pictures: as asked for, or evenly spread.
std::vector<double> choose_times(const DrawOptions& options, const RecordedMotion& motion) {
  if (!options.times.empty()) return options.times;
  std::vector<double> times;
  const double first = motion.times.front();
  const double last = motion.times.back();
  for (int i = 0; i < options.pictures; ++i) {
    times.push_back(options.pictures == 1 ? last
                                          : first + (last - first) * i / (options.pictures - 1));
  }
  return times;
}

/// Whether the motion has these times, to the digits that are shown; else with an error.
bool are_within(const std::vector<double>& times, const RecordedMotion& motion,
                const std::string& file, Diagnostics& diagnostics) {
  const double first = motion.times.front();
  const double last = motion.times.back();
  const double slack = 1e-3 * (last - first);
  const auto beyond = std::find_if(times.begin(), times.end(), [&](double time) {
    return time < first - slack || time > last + slack;
  });
  if (beyond == times.end()) return true;
  diagnostics.add({Severity::error, file, 0, "--times",
                   fmt::format("{:g} s is not in the motion, which goes from {:g} to {:g} s",
                               *beyond, first, last),
                   "give times within it"});
  return false;
}

/// Path of the point up to a row, in at most some hundred steps.
std::vector<Eigen::Vector3d> trace_path(const LinkPlacer& placer, const RecordedMotion& motion,
                                        std::size_t point, std::size_t row) {
  constexpr std::size_t kSteps = 120;
  const std::size_t stride = std::max<std::size_t>(1, motion.times.size() / kSteps);
  std::vector<Eigen::Vector3d> path;
  for (std::size_t k = 0; k < row; k += stride) {
    path.push_back(placer.place_points(motion.q[k])[point].translation());
  }
  path.push_back(placer.place_points(motion.q[row])[point].translation());
  return path;
}

std::optional<std::vector<Moment>> choose_moments(const DrawOptions& options, const Drawn& drawn,
                                                  const LinkPlacer& placer,
                                                  Diagnostics& diagnostics) {
  if (options.motion.empty()) {
    if (!has_size("--q", options.q, placer.coordinates(), diagnostics)) return std::nullopt;
    return std::vector<Moment>{
        {options.q.empty() ? placer.home() : options.q, drawn.robot.name, {}, {}}};
  }
  const auto motion = read_motion(options.motion, placer.joints(), placer.home(), diagnostics);
  if (!motion) return std::nullopt;
  std::optional<std::size_t> point;
  if (!options.path.empty()) {
    point = find_point(drawn, options.path, diagnostics);
    if (!point) return std::nullopt;
  }
  if (!are_within(options.times, *motion, options.motion, diagnostics)) return std::nullopt;
  std::vector<Moment> moments;
  for (const double time : choose_times(options, *motion)) {
    const std::size_t row = row_at(*motion, time);
    moments.push_back({motion->q[row], fmt::format("{:.4g} s", time), {}, {}});
    if (point) moments.back().path = trace_path(placer, *motion, *point, row);
  }
  return moments;
}

int draw(const DrawOptions& options, Diagnostics& diagnostics) {
  auto drawn = read_files(options, diagnostics);
  if (!drawn) return kBadInput;
  split_if_driven(options, *drawn);
  const LinkPlacer placer(drawn->robot, drawn->scene);
  auto moments = choose_moments(options, *drawn, placer, diagnostics);
  if (!moments) return kBadInput;
  for (Moment& moment : *moments) {
    moment.held = object_solids(drawn->scene.objects, drawn->surroundings.shapes,
                                drawn->scene.operational_points, placer.place_points(moment.q));
  }
  const std::string svg = draw_robot(drawn->robot, placer, drawn->visuals, *moments, options.view,
                                     obstacle_solids(drawn->surroundings.obstacles));
  if (options.svg.empty() || options.svg == "-") return write_output(svg, OutputForm::text, kOk);
  drawn->files.push_back(options.motion);
  return write_output_file(options.svg, svg, diagnostics, drawn->files) ? kOk : kBadInput;
}

void add_options(CLI::App& command, DrawOptions& options) {
  command.add_option("urdf", options.urdf, kRobotArgument)->required();
  command.add_option("scene", options.scene, "Base, locked joints, points; YAML");
  auto* q =
      command.add_option("--q", options.q, "Where it stands, separated by commas; else at rest")
          ->delimiter(',')
          ->check(any_number());
  auto* motion = command
                     .add_option("--motion", options.motion,
                                 "Draw a motion: table of simulate --csv or of an experiment, "
                                 "or record of drive")
                     ->excludes(q);
  auto* times = command.add_option("--times", options.times, "s, a picture each")
                    ->delimiter(',')
                    ->check(any_number())
                    ->needs(motion);
  command.add_option("--pictures", options.pictures, "So many, evenly spread")
      ->check(whole_between(1, 100))
      ->capture_default_str()
      ->excludes(times);
  command.add_option("--path", options.path, "Operational point whose path is drawn")
      ->needs(motion);
  command.add_option("--azimuth", options.view.azimuth, "Of the camera about z, rad")
      ->check(any_number())
      ->capture_default_str();
  command.add_option("--elevation", options.view.elevation, "Of the camera over the ground, rad")
      ->check(any_number())
      ->capture_default_str();
  command.add_option("--svg", options.svg, "File to write; else standard output");
  add_warnings_option(command, options.warnings);
}

}  // namespace

void add_draw(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<DrawOptions>();
  CLI::App* command =
      app.add_subcommand("draw", "Draw a robot, or moments of its motion side by side, as SVG");
  add_options(*command, *options);
  command->footer(
      "Boxes, cylinders and spheres of the URDF are drawn; where a link has meshes only, those by\n"
      "which it collides, or rods if there are none.\n"
      "Examples:\n"
      "  treeline draw puma560.urdf --q 0,-0.7,0.7,0,0.5,0 --svg puma.svg\n"
      "  treeline simulate planar3r.urdf --csv swing.csv\n"
      "  treeline draw planar3r.urdf --motion swing.csv --pictures 6 --svg swing.svg\n"
      "  treeline draw arm.urdf scene.yaml --motion record.jsonl --path tool --svg strip.svg");
  command->callback([options, &exit_code] {
    Diagnostics diagnostics;
    exit_code = draw(*options, diagnostics);
    print_diagnostics(diagnostics, options->warnings);
  });
}

}  // namespace treeline
