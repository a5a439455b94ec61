#include "description/read_scene.hpp"

#include <fmt/format.h>

#include "description/check_scene.hpp"
#include "description/follow_target.hpp"
#include "description/noise.hpp"
#include "description/parse_yaml.hpp"
#include "description/read_keys.hpp"
#include "description/read_surroundings.hpp"
#include "description/scene_element.hpp"
#include "description/scene_queries.hpp"
#include "description/snap_angles.hpp"
#include "text/identifier.hpp"
#include "text/read_text_file.hpp"

namespace treeline {
namespace {

/// Robots that the scene lists itself have been read before it, see `read_robots`.
void check_robots(const SceneFields& fields, const Robot& robot) {
  const auto list = fields.find("robots");
  if (list == fields.end()) return;
  if (robot.parts.empty()) {
    list->second.error("this scene lists its robots itself, but a URDF is given beside it",
                       "name the scene alone: treeline generate scene.yaml");
  } else if (const auto base = fields.find("base"); base != fields.end()) {
    base->second.error("each robot has a base of its own", "write base into the list robots");
  }
}

bool is_empty_list(const SceneElement& element) {
  return element.is_list() && element.items().empty();
}

Scene read_fields(const SceneElement& top, const Robot& robot) {
  Scene scene;
  scene.name = package_name_from(robot.name);
  std::vector<std::string> known;
  for (const SceneKey& key : scene_keys()) known.emplace_back(key.name);
  const auto fields = top.fields(known);
  check_robots(fields, robot);
  if (!fields.contains("base") && robot.parts.empty()) scene.base = default_base(robot);
  add_loops_of_robot(robot, scene);
  for (const SceneKey& key : scene_keys()) {
    const auto field = fields.find(key.name);
    if (field != fields.end() && key.read != nullptr) key.read(field->second, robot, scene);
    if (field == fields.end() && key.note_absence != nullptr) key.note_absence(top, robot);
  }
  const auto ground = read_surroundings(fields, robot).ground;
  if (ground && ground->step) scene.ground_step = ground;
  if (const auto listed = fields.find("functions"); listed != fields.end() &&
                                                    is_empty_list(listed->second) &&
                                                    !scene.controller && !scene.ground_step) {
    listed->second.error("no function is listed, and no controller",
                         "list some, or leave out the key for all");
  }
  follow_target(scene);
  return scene;
}

void note_missing_scene(const Robot& robot, const Scene& scene, Diagnostics& diagnostics) {
  const std::string base = scene.base == Base::floating
                               ? fmt::format("the base floats, for {}", why_floating(robot))
                               : "the base is fixed";
  diagnostics.add({Severity::note, robot.file, 0, "",
                   fmt::format("there is no scene: functions of the joints alone, and {}", base),
                   "`treeline init-scene` writes a scene to start from"});
}

}  // namespace

std::optional<Scene> parse_scene(const std::string& text, const std::string& file_name,
                                 const Robot& robot, Diagnostics& diagnostics,
                                 const std::vector<Function>& functions, FunctionsFrom from) {
  const auto document = parse_yaml(text, file_name, diagnostics);
  if (!document) return std::nullopt;
  // Without a scene, what cannot be is told of the robot.
  SceneReading reading{file_name.empty() ? robot.file : file_name, diagnostics, alias_lines(text)};
  SceneReading of_option{"", diagnostics};
  const SceneElement top(*document, "", reading);
  Scene scene = read_fields(top, robot);
  scene.file = file_name;
  if (!functions.empty()) scene.functions = functions;
  if (!reading.failed) {
    const bool listed = (*document)["functions"].IsDefined() || !functions.empty();
    const SceneElement given(YAML::Node(), kFunctionsOption, of_option);
    complete_scene(top, functions.empty() ? top.at("functions") : given, robot, listed, scene);
  }
  if (reading.failed || of_option.failed) return std::nullopt;
  if (from == FunctionsFrom::scene) warn_of_unused(top, scene);
  if (!file_name.empty() && scene.base == Base::floating && !(*document)["base"]) {
    top.note(fmt::format("the scene says nothing of the base, which floats, for {}",
                         why_floating(robot)),
             "write base: floating or base: fixed to choose");
  }
  if (!robot.loops.empty()) {
    diagnostics.add(
        {Severity::note, robot.file, 0, "",
         fmt::format("{} loops are closed by functions about constraints; to all others "
                     "the robot is the open tree",
                     robot.loops.size()),
         "use constrained_forward_dynamics and supported_control_torque"});
  }
  snap_angles(robot, scene, diagnostics);
  if (scene.noise <= kResolution) return scene;
  NoiseDecisions decisions;
  const auto limits = noise_limits(robot, scene);
  scene = without_noise(std::move(scene), limits, &decisions);
  scene.taken_exact = std::move(decisions);
  return scene;
}

std::optional<Scene> read_scene(const std::string& path, const Robot& robot,
                                Diagnostics& diagnostics, const std::vector<Function>& functions) {
  const auto text = path.empty() ? std::string() : read_text_file(path, diagnostics);
  if (!text) return std::nullopt;
  auto scene = parse_scene(*text, shown_path(path), robot, diagnostics, functions);
  if (scene && path.empty()) note_missing_scene(robot, *scene, diagnostics);
  return scene;
}

}  // namespace treeline
