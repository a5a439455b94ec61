#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "description/robot_queries.hpp"
#include "description/rotation.hpp"
#include "description/urdf_parts.hpp"

namespace treeline {
namespace {

constexpr const char* kEnds =
    "write <link1 link=\"...\" xyz=\"...\" rpy=\"...\"/> and <link2 .../>";

bool has_link(const Robot& robot, const std::string& name) {
  return std::any_of(robot.links.begin(), robot.links.end(),
                     [&](const Link& each) { return each.name == name; });
}

/// Sets the link of an end; an error where the robot does not have it.
void name_link(const UrdfElement& element, const std::string& name, const Robot& robot,
               RobotLoop::End& end) {
  end.link = name;
  if (has_link(robot, name)) return;
  element.error(fmt::format("there is no link \"{}\"", name), suggest_link(name, robot));
}

RobotLoop::End read_end(const UrdfElement& element, const char* name, const Robot& robot) {
  RobotLoop::End end;
  const auto found = element.child(name);
  if (!found) {
    element.error(fmt::format("<{}> is missing", name), kEnds);
    return end;
  }
  found->holds_only_attributes({"link", "xyz", "rpy"});
  const auto link = found->required_text("link", kEnds);
  end.origin.xyz = found->three_numbers("xyz").value_or(end.origin.xyz);
  end.origin.rpy = found->three_numbers("rpy").value_or(end.origin.rpy);
  if (link) name_link(*found, *link, robot, end);
  return end;
}

/// Rows that each kind of joint holds when its axis is z, in the order x y z rx ry rz.
struct LoopKind {
  const char* type;
  std::array<bool, 6> rows;
  bool has_axis;
};
constexpr std::array kKinds{LoopKind{"spherical", {true, true, true, false, false, false}, false},
                            LoopKind{"fixed", {true, true, true, true, true, true}, false},
                            LoopKind{"revolute", {true, true, true, true, true, false}, true},
                            LoopKind{"continuous", {true, true, true, true, true, false}, true},
                            LoopKind{"prismatic", {true, true, false, true, true, true}, true}};

/// The rotation by which z becomes the axis, put behind that of the pose.
void turn_z_to(const std::array<double, 3>& axis, Pose& pose) {
  const double azimuth = std::atan2(axis[1], axis[0]);
  const double polar = std::atan2(std::hypot(axis[0], axis[1]), axis[2]);
  const Eigen::Matrix3d R =
      rotation_from_rpy<double>(pose.rpy) * rotation_from_rpy<double>({0, polar, azimuth});
  pose.rpy = rpy_from_rotation(R);
}

/// Rows along the axes of both frames. Where the joint's axis is one of these in both, the frames
/// stay as the file has them, exactly.
void hold(const LoopKind& kind, const std::array<double, 3>& axis,
          const std::array<double, 3>& other, RobotLoop& loop) {
  loop.rows = kind.rows;
  if (!kind.has_axis) return;
  if (axis != other || std::count(axis.begin(), axis.end(), 0.0) != 2) {
    turn_z_to(axis, loop.first.origin);
    turn_z_to(other, loop.second.origin);
    return;
  }
  const auto along =
      std::find_if(axis.begin(), axis.end(), [](double component) { return component != 0; });
  const auto k = static_cast<std::size_t>(along - axis.begin());
  std::swap(loop.rows[k], loop.rows[2]);
  std::swap(loop.rows[k + 3], loop.rows[5]);
}

/// The kind that `type` names; null, with an error, if there is none.
const LoopKind* read_kind(const UrdfElement& element) {
  const char* const remedy =
      "write type=\"spherical\", \"fixed\", \"revolute\", \"continuous\" or \"prismatic\"; other "
      "rows can be held under constraints in the scene";
  const auto type = element.required_text("type", remedy);
  if (!type) return nullptr;
  const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                 [&](const LoopKind& each) { return *type == each.type; });
  if (kind != kKinds.end()) return &*kind;
  element.error(fmt::format("type=\"{}\" of a joint that closes a loop is not known", *type),
                remedy);
  return nullptr;
}

/// One end of a `<constraint>`: `side` is `parent` or `child`.
RobotLoop::End read_side(const UrdfElement& element, const std::string& side, const Robot& robot) {
  RobotLoop::End end;
  const auto link = element.child(side.c_str());
  if (!link) return end;
  if (const auto name = link->required_text("link", "name the link")) {
    name_link(*link, *name, robot, end);
  }
  if (const auto origin = element.child((side + "_origin").c_str())) {
    end.origin.xyz = origin->three_numbers("xyz").value_or(end.origin.xyz);
    end.origin.rpy = origin->three_numbers("rpy").value_or(end.origin.rpy);
  }
  return end;
}

}  // namespace

bool is_loop_joint(const UrdfElement& element) {
  return element.name() == "loop_joint" && element.xml().FirstChildElement("link1") != nullptr;
}

void read_loop_joint(const UrdfElement& element, Robot& robot) {
  element.only_attributes({"name", "type"});
  element.only_children({"axis", "link1", "link2"});
  RobotLoop loop;
  loop.name = element.required_name("give it a name");
  loop.first = read_end(element, "link1", robot);
  loop.second = read_end(element, "link2", robot);
  if (const LoopKind* kind = read_kind(element)) {
    const auto axis = read_axis(element);
    hold(*kind, axis, axis, loop);
  }
  const auto same = [&](const RobotLoop& other) { return other.name == loop.name; };
  if (std::any_of(robot.loops.begin(), robot.loops.end(), same)) {
    element.error("a loop of this name is already there", "give each loop a name of its own");
  }
  robot.loops.push_back(std::move(loop));
}

bool is_constraint(const UrdfElement& element) {
  return element.name() == "constraint" && element.child("parent") && element.child("child");
}

void read_constraint_hint(const UrdfElement& element, Robot& robot) {
  element.only_attributes({"name", "type"});
  element.only_children(
      {"parent", "parent_origin", "parent_axis", "child", "child_origin", "child_axis"});
  RobotLoop loop;
  loop.name = element.required_name("give it a name");
  loop.first = read_side(element, "parent", robot);
  loop.second = read_side(element, "child", robot);
  const LoopKind* const kind = read_kind(element);
  if (kind == nullptr) return;
  hold(*kind, read_axis(element, "parent_axis"), read_axis(element, "child_axis"), loop);
  element.reading().report(Severity::note, element.line(), element.path(),
                           "a loop that stays open unless the scene closes it",
                           "`treeline init-scene` proposes a constraint");
  robot.hints.loops.push_back(
      {std::move(loop), fmt::format("<constraint> of line {}", element.line())});
}

void find_closing_frames(Robot& robot, UrdfReading& reading) {
  for (const Link& link : robot.links) {
    if (!link.name.starts_with("closing_") || !link.name.ends_with("_1")) continue;
    const std::string stem = link.name.substr(0, link.name.size() - 2);
    if (!has_link(robot, stem + "_2")) continue;
    reading.report(Severity::note, link.line, fmt::format("robot/link[{}]", link.name),
                   fmt::format("it is to meet {}_2: a loop that stays open unless the scene closes "
                               "it",
                               stem),
                   "`treeline init-scene` proposes a constraint");
    RobotLoop loop{
        stem, {link.name, {}}, {stem + "_2", {}}, {true, true, true, false, false, false}};
    robot.hints.loops.push_back(
        {std::move(loop), fmt::format("links {}_1 and {}_2, which are to meet", stem, stem)});
  }
}

}  // namespace treeline
