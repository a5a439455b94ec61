#include "description/read_robot_text.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "description/flat/flat_model.hpp"
#include "description/mjcf/read_bodies.hpp"
#include "description/read_robots.hpp"
#include "description/read_urdf.hpp"
#include "description/scan_xml.hpp"
#include "description/sdf/read_sdf.hpp"
#include "text/read_text_file.hpp"

namespace treeline {
namespace {

/// Name of the first element; empty where there is none.
std::string_view name_of_root(std::string_view text) {
  std::size_t at = 0;
  while (const auto tag = next_tag(text, at)) {
    if (tag->kind != XmlTag::Kind::other) return tag->name;
  }
  return {};
}

RobotText as_urdf(const FlatModel& model, const FlatTree& tree, const char* format,
                  const std::string& file, Diagnostics& diagnostics) {
  diagnostics.add({Severity::note, file, 0, format,
                   fmt::format("read as a URDF, with {} joints in the tree and {} that close loops",
                               tree.joints.size(), tree.loops.size()),
                   "`treeline convert` prints it; other messages name its lines"});
  return {print_urdf(model, tree), file + " as URDF", {}};
}

/// Two of the kinds of SDF have no counterpart among joints that close loops.
bool can_close(const FlatTree& tree, const std::string& file, Diagnostics& diagnostics) {
  bool can = true;
  for (const FlatJoint& loop : tree.loops) {
    if (loop.axes.size() < 2) continue;
    can = false;
    diagnostics.add({Severity::error, file, 0, fmt::format("sdf/model/joint[{}]", loop.name),
                     fmt::format("a joint of type {} closes a loop", loop.type),
                     "let another joint of the loop close it: the last one in the file does"});
  }
  return can;
}

}  // namespace

std::optional<RobotText> as_robot_text(std::string text, const std::string& path,
                                       Diagnostics& diagnostics) {
  const std::string file = shown_path(path);
  const std::string_view root = name_of_root(text);
  if (root == "mujoco") {
    const auto read = read_mjcf(text, path, diagnostics);
    if (!read) return std::nullopt;
    RobotText urdf = as_urdf(read->model, read->tree, "mujoco", file, diagnostics);
    urdf.hints = read->hints;
    return urdf;
  }
  if (root != "sdf") return RobotText{std::move(text), file, {}};
  const auto model = read_sdf(text, path, diagnostics);
  const auto tree = model ? span_tree(*model, file, diagnostics) : std::nullopt;
  if (!tree || !can_close(*tree, file, diagnostics)) return std::nullopt;
  return as_urdf(*model, *tree, "sdf", file, diagnostics);
}

std::optional<RobotText> read_robot_text(const std::string& path, Diagnostics& diagnostics) {
  auto text = read_text_file(path, diagnostics);
  if (!text) return std::nullopt;
  if (is_scene_text(*text)) {
    diagnostics.add({Severity::error, shown_path(path), 0, "", "this is a scene, not a robot",
                     lists_robots(*text)
                         ? "name a robot; `generate`, `check` and `drive` take a scene that "
                           "lists robots in place of one"
                         : "name a robot; `generate`, `check` and `drive` take a scene as "
                           "their second argument, behind the robot"});
    return std::nullopt;
  }
  return as_robot_text(std::move(*text), path, diagnostics);
}

std::optional<Robot> parse_robot(const RobotText& text, Diagnostics& diagnostics) {
  auto robot = parse_urdf(text.urdf, text.shown, diagnostics);
  if (!robot) return robot;
  auto loops = std::move(robot->hints.loops);
  robot->hints = text.hints;
  robot->hints.loops = std::move(loops);
  return robot;
}

}  // namespace treeline
