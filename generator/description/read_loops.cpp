#include "description/read_loops.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "description/list_links.hpp"
#include "description/read_joint.hpp"
#include "description/rotation.hpp"
#include "description/rpy_from_rotation.hpp"

namespace treeline {
namespace {

constexpr const char* kEnds =
    "write <link1 link=\"...\" xyz=\"...\" rpy=\"...\"/> and <link2 .../>";

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
  if (!link) return end;
  end.link = *link;
  if (std::none_of(robot.links.begin(), robot.links.end(),
                   [&](const Link& each) { return each.name == end.link; })) {
    found->error(fmt::format("there is no link \"{}\"", end.link), suggest_link(end.link, robot));
  }
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

/// Rows along the axes of both frames. Where the joint's axis is one of these, the frames stay as
/// the file has them, exactly.
void hold(const LoopKind& kind, const std::array<double, 3>& axis, RobotLoop& loop) {
  loop.rows = kind.rows;
  if (!kind.has_axis) return;
  if (std::count(axis.begin(), axis.end(), 0.0) != 2) {
    turn_z_to(axis, loop.first.origin);
    turn_z_to(axis, loop.second.origin);
    return;
  }
  const auto along =
      std::find_if(axis.begin(), axis.end(), [](double component) { return component != 0; });
  const auto k = static_cast<std::size_t>(along - axis.begin());
  std::swap(loop.rows[k], loop.rows[2]);
  std::swap(loop.rows[k + 3], loop.rows[5]);
}

void read_kind(const UrdfElement& element, RobotLoop& loop) {
  const char* const remedy =
      "write type=\"spherical\", \"fixed\", \"revolute\", \"continuous\" or \"prismatic\"; other "
      "rows can be held under constraints in the scene";
  const auto type = element.required_text("type", remedy);
  if (!type) return;
  const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                 [&](const LoopKind& each) { return *type == each.type; });
  if (kind == kKinds.end()) {
    element.error(fmt::format("type=\"{}\" of a joint that closes a loop is not known", *type),
                  remedy);
    return;
  }
  hold(*kind, read_axis(element), loop);
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
  read_kind(element, loop);
  const auto same = [&](const RobotLoop& other) { return other.name == loop.name; };
  if (std::any_of(robot.loops.begin(), robot.loops.end(), same)) {
    element.error("a loop of this name is already there", "give each loop a name of its own");
  }
  robot.loops.push_back(std::move(loop));
}

}  // namespace treeline
