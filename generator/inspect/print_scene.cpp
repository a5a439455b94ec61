#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "description/scene_queries.hpp"
#include "description/urdf_parts.hpp"
#include "inspect/propose_scene.hpp"
#include "text/identifier.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

constexpr std::size_t kCommentColumns = 96;

/// Writes a name such that YAML reads it back: without quotes if nothing in it is special.
std::string yaml_word(const std::string& name) {
  constexpr std::array<std::string_view, 10> kSpecial = {"true", "false", "yes", "no", "on",
                                                         "off",  "null",  "y",   "n",  "nan"};
  std::string lower = name;
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_plain = [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || std::string_view("_-./").find(c) < 4;
  };
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const bool special = std::find(kSpecial.begin(), kSpecial.end(), lower) != kSpecial.end();
  if (!name.empty() && !special && (is_letter(name[0]) || name[0] == '_') &&
      std::all_of(name.begin(), name.end(), is_plain)) {
    return name;
  }
  std::string quoted = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return printable_json(quoted) + "\"";
}

/// A comment of several lines, broken at spaces.
std::string remark(const std::string& text) {
  std::string lines;
  std::string line = "#";
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (line.size() + 1 + word.size() > kCommentColumns && line != "#") {
      lines += line + "\n";
      line.resize(1);
    }
    line += fmt::format(" {}", word);
    begin = end + 1;
  }
  return lines + line + "\n";
}

std::string print_head(const Robot& robot, const SceneProposal& proposal, const std::string& file) {
  return remark(fmt::format("A scene for {}, taken as {}: guessed by `treeline init-scene {}` from "
                            "the shape of the "
                            "tree, masses, joints and names.",
                            printable(robot.name), proposal.kind, file)) +
         "#\n# What it cannot know, and somebody who knows the robot should correct:\n" +
         "# - whether the base is held, and where the tool's tip is: points lie at origins of "
         "links\n"
         "# - which rows a task needs, which points it needs at all, and which come first "
         "(`priority`)\n"
         "# - what the robot touches, holds or carries (`contacts`, `objects`, `external_forces`)\n"
         "# - where it becomes singular: see `treeline inspect` with this scene, and `damped`\n"
         "# `treeline keys` explains every key; leave out a key for its default.\n\n" +
         fmt::format("name: {}  # namespace, header and folder of the code\n\n",
                     yaml_word(package_name_from(robot.name)));
}

std::string print_base(const Robot& robot, const SceneProposal& proposal) {
  const auto gravity = robot.hints.gravity.value_or(Scene{}.gravity);
  const bool floats = proposal.base == Base::floating;
  return remark(fmt::format("{}, because {}. Write {} if that is wrong.",
                            floats ? "Floating" : "Fixed", printable(proposal.base_reason),
                            floats ? "fixed" : "floating")) +
         fmt::format("base: {}\n\n", floats ? "floating" : "fixed") +
         fmt::format("gravity: [{}]  # m/s^2, in the axes of the world\n",
                     fmt::join(gravity, ", ")) +
         "real: double  # or float\n\n";
}

std::string print_origin(const char* key, const Pose& pose) {
  if (pose.xyz == Pose{}.xyz && pose.rpy == Pose{}.rpy) return {};
  return fmt::format("    {}: {{xyz: [{}], rpy: [{}]}}\n", key, fmt::join(pose.xyz, ", "),
                     fmt::join(pose.rpy, ", "));
}

std::string print_points(const Robot& robot, const SceneProposal& proposal) {
  if (proposal.points.empty()) {
    return remark(
               "No end of the tree was found that a task could move: functions of the joints "
               "alone.") +
           "# operational_points:\n#   - {name: tool, link: LINK, rows: [x, y, z]}\n";
  }
  std::string text = remark(
      fmt::format("Ends of limbs, or links before them that are called tool, hand or foot. "
                  "`rows` are those in world axes that the joints can move independently of each "
                  "other, of all points together, found at {} states within the limits.",
                  kRowStates));
  text += "operational_points:\n";
  Scene scene;
  scene.base = proposal.base;
  for (const ScenePoint& point : proposal.points) {
    const int freedoms = count(find_freedoms_of_link(robot, scene, point.link));
    const auto remark = proposal.remarks.find(point.link);
    text += fmt::format("  - name: {}\n    link: {}  # moved by {} coordinate{}{}\n",
                        yaml_word(point.name), yaml_word(point.link), freedoms,
                        freedoms == 1 ? "" : "s",
                        remark == proposal.remarks.end() ? "" : "; " + remark->second) +
            print_origin("origin", point.origin) +
            fmt::format("    rows: [{}]\n", list_rows(point, ", "));
  }
  return text + "    # origin: {xyz: [0, 0, 0.1], rpy: [0, 0, 0]}  # of a point in its link\n";
}

/// How it stands in `drive`, which no robot with closed loops does: two feet flat, more of them on
/// points.
std::string print_feet(const Robot& robot, const SceneProposal& proposal) {
  if (proposal.feet.size() < 2 || !robot.hints.loops.empty()) return {};
  const bool flat = proposal.feet.size() == 2;
  std::string text = "\n";
  text += remark(
      "To let it stand on the ground in `treeline drive`, by its motors, in place of its feet's "
      "points:");
  text += "# ground: {friction: 0.8}\n# constraints:\n";
  for (const ScenePoint& foot : proposal.feet) {
    const auto& xyz = foot.origin.xyz;
    const std::string origin = xyz == Pose{}.xyz
                                   ? std::string()
                                   : fmt::format(", origin: {{xyz: [{}]}}", fmt::join(xyz, ", "));
    text += fmt::format("#   - {{name: {}, between: [{}, world]{}{}}}\n", yaml_word(foot.name),
                        yaml_word(foot.link), flat ? "" : ", contact: point", origin);
  }
  return text;
}

std::string print_left_out(const SceneProposal& proposal) {
  if (proposal.left_out.empty()) return {};
  std::string list;
  for (const std::string& link : proposal.left_out) {
    list += (list.empty() ? "" : ", ") + printable(link);
  }
  return remark("Other ends, which have no point here: " + list + ".");
}

/// A value at which the joint can rest: 0, or its limit nearest to 0.
double rest_of(const Joint& joint) {
  if (!joint.limits) return 0;
  return std::min(std::max(0.0, joint.limits->lower.value()), joint.limits->upper.value());
}

std::string print_locked(const Robot& robot, const SceneProposal& proposal) {
  if (proposal.beyond.empty()) return {};
  std::string text = "\n";
  text += remark(
      "Joints beyond the points, as of fingers, have coordinates too. Held still they cost "
      "nothing:");
  text += "# locked:\n";
  for (const std::string& name : proposal.beyond) {
    for (const Joint& joint : robot.joints) {
      if (joint.name == name) text += fmt::format("#   {}: {}\n", yaml_word(name), rest_of(joint));
    }
  }
  return text;
}

std::string print_rotors(const Robot& robot) {
  const bool has_rotors = std::any_of(robot.joints.begin(), robot.joints.end(),
                                      [](const Joint& joint) { return armature_of(joint) > 0; });
  if (!has_rotors) return {};
  std::string text = "\n";
  text += remark("The file states the inertias of motors' rotors. To add them to their joints:");
  return text + "# armature: file\n";
}

std::string print_friction(const Robot& robot) {
  const bool has_friction =
      std::any_of(robot.joints.begin(), robot.joints.end(),
                  [](const Joint& joint) { return joint.damping > 0 || joint.friction > 0; });
  if (!has_friction) return {};
  std::string text = "\n";
  text += remark("The file states damping or friction of joints. To count it:");
  return text + "# joint_friction: viscous\n";
}

std::string print_springs(const Robot& robot) {
  if (robot.hints.springs.empty()) return {};
  std::string text = "\n";
  text += remark("The file states springs of joints. To count them:") + "# joint_springs:\n";
  for (const auto& [joint, spring] : robot.hints.springs) {
    text += fmt::format("#   {}: {{stiffness: {}, rest: {}}}\n", yaml_word(joint), spring.stiffness,
                        spring.rest);
  }
  return text;
}

std::string print_loops(const Robot& robot) {
  if (robot.hints.loops.empty()) return {};
  std::string text = "\n";
  text +=
      remark("Loops that the file leaves open. Add rx, ry, rz where more than a point is held.") +
      "constraints:\n";
  for (const auto& [loop, reason] : robot.hints.loops) {
    ScenePoint point;
    point.rows = loop.rows;
    text += fmt::format("  - name: {}  # {}\n    between: [{}, {}]\n    rows: [{}]\n",
                        yaml_word(identifier_from(loop.name)), printable(reason),
                        yaml_word(loop.first.link), yaml_word(loop.second.link),
                        list_rows(point, ", ")) +
            print_origin("origin", loop.first.origin) +
            print_origin("other_origin", loop.second.origin);
  }
  return text;
}

std::string print_functions(const std::vector<Function>& functions) {
  std::string text = "\n";
  text += remark(
      "All functions that this scene permits are made. To have fewer, list those that you need:");
  text += "# functions:\n";
  for (const Function function : functions) {
    text += fmt::format("#   - {}\n", function_name(function));
  }
  return text;
}

}  // namespace

std::string print_scene(const Robot& robot, const SceneProposal& proposal, const std::string& file,
                        const std::vector<Function>& functions) {
  return print_head(robot, proposal, file) + print_base(robot, proposal) +
         print_points(robot, proposal) + print_left_out(proposal) + print_feet(robot, proposal) +
         print_locked(robot, proposal) + print_rotors(robot) + print_friction(robot) +
         print_springs(robot) + print_loops(robot) + print_functions(functions);
}

}  // namespace treeline
