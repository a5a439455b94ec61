#include "cli/read_robot_files.hpp"

#include <utility>

#include "description/read_robot_text.hpp"
#include "description/read_urdf.hpp"
#include "description/scene_queries.hpp"
#include "text/read_text_file.hpp"

namespace treeline {
namespace {

void reject(const std::string& file, const char* fault, const char* remedy,
            Diagnostics& diagnostics) {
  diagnostics.add({Severity::error, shown_path(file), 0, "", fault, remedy});
}

std::optional<RobotWithFiles> read_listed(const std::string& scene, std::string text,
                                          const std::string& second, Diagnostics& diagnostics) {
  if (!second.empty()) {
    reject(second, "the scene before this file lists its robots itself", "name that scene alone",
           diagnostics);
    return std::nullopt;
  }
  auto found = read_robots(text, scene, diagnostics);
  if (!found) return std::nullopt;
  RobotFiles files;
  files.scene = scene;
  files.scene_text = std::move(text);
  files.scene_robots = std::move(*found);
  Robot robot = join_robots(files.scene_robots.robots, shown_path(scene));
  return RobotWithFiles{std::move(robot), std::move(files)};
}

}  // namespace

std::optional<RobotWithFiles> read_robot_files(const std::string& first, const std::string& second,
                                               Diagnostics& diagnostics) {
  if (!can_read_both(first, second, diagnostics)) return std::nullopt;
  auto text = read_text_file(first, diagnostics);
  if (!text) return std::nullopt;
  if (lists_robots(*text)) return read_listed(first, std::move(*text), second, diagnostics);
  if (is_scene_text(*text)) {
    reject(first, "this is a scene and not a URDF, and it lists no robots",
           "name the URDF before it, or list robots: [{name: left, urdf: arm.urdf}] in it",
           diagnostics);
    return std::nullopt;
  }
  auto robot_text = as_robot_text(std::move(*text), first, diagnostics);
  if (!robot_text) return std::nullopt;
  auto robot = parse_robot(*robot_text, diagnostics);
  if (!robot) return std::nullopt;
  auto scene_text = second.empty() ? std::string() : read_text_file(second, diagnostics);
  if (!scene_text) return std::nullopt;
  return RobotWithFiles{std::move(*robot),
                        {first, std::move(robot_text->urdf), second, std::move(*scene_text), {}}};
}

std::optional<Scene> parse_scene_of(const RobotWithFiles& read, Diagnostics& diagnostics,
                                    const std::vector<Function>& functions, FunctionsFrom from) {
  const RobotFiles& files = read.files;
  if (files.scene.empty()) return read_scene("", read.robot, diagnostics, functions);
  return parse_scene(files.scene_text, shown_path(files.scene), read.robot, diagnostics, functions,
                     from);
}

std::string place_of_list(const RobotFiles& files, const std::vector<Function>& functions) {
  if (!functions.empty()) return kFunctionsOption;
  return states_key(files.scene_text, "functions") ? "functions" : "";
}

std::vector<std::string> list_paths(const RobotFiles& files) {
  std::vector<std::string> paths;
  for (const std::string& file : {files.urdf, files.scene}) {
    if (!file.empty() && file != "-") paths.push_back(file);
  }
  for (const InputFile& file : files.scene_robots.files) paths.push_back(file.path);
  return paths;
}

std::string shown_urdf(const RobotFiles& files) {
  return files.urdf.empty() ? print_joined_urdf(files.scene_robots) : files.urdf_text;
}

}  // namespace treeline
