#include "inspect/inspect_robot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "description/inertias.hpp"
#include "description/robot_queries.hpp"
#include "description/scene_queries.hpp"
#include "mechanism/build_mechanism.hpp"
#include "text/identifier.hpp"

namespace treeline {
namespace {

const char* unit_of(JointType type) {
  if (!info_of(type).has_one_freedom()) return "";
  return info_of(type).slides() ? "m" : "rad";
}

std::string describe(const Mimic& mimic, const Robot& robot) {
  const std::string& name = robot.joints[static_cast<std::size_t>(mimic.joint)].name;
  std::string text = mimic.multiplier == 1 ? name : fmt::format("{} * {}", mimic.multiplier, name);
  if (mimic.offset != 0) {
    text += fmt::format(" {} {}", mimic.offset < 0 ? '-' : '+', std::abs(mimic.offset));
  }
  return text;
}

/// Visits the tree in the order of the coordinates: depth-first, children in the file's order.
class Walk {
 public:
  Walk(const Robot& robot, const Scene& scene, Report& report)
      : robot_(robot), scene_(scene), report_(report) {}

  void visit_all() {
    if (scene_.base == Base::floating) add_floating_base();
    add_links();
    number_mimics();
  }

 private:
  struct Visit {
    std::size_t link;
    int parent;      ///< index into Report::links
    int joint = -1;  ///< index into Robot::joints
  };

  void add_links() {
    std::vector<int> added(robot_.links.size());  // by link: its index in Report::links
    const auto root = static_cast<std::size_t>(robot_.root);
    added[root] = add_link({root, -1});
    for (const int j : joints_depth_first(robot_)) {
      const Joint& joint = robot_.joints[static_cast<std::size_t>(j)];
      const auto child = static_cast<std::size_t>(joint.child);
      added[child] = add_link({child, added[static_cast<std::size_t>(joint.parent)], j});
    }
  }

  int add_link(const Visit& visit) {
    const Link& link = robot_.links[visit.link];
    LinkReport result;
    result.name = link.name;
    result.parent = visit.parent;
    if (visit.joint < 0) {
      result.moves = scene_.base == Base::floating;
      result.motion = result.moves ? "floating" : "fixed";
    } else {
      add_joint(static_cast<std::size_t>(visit.joint), result);
    }
    if (!result.moves && visit.parent >= 0) {
      const LinkReport& parent = parent_of(result);
      result.lumped_with = parent.lumped_with.empty() ? parent.name : parent.lumped_with;
    }
    add_inertial(link, result);
    report_.links.push_back(result);
    return static_cast<int>(report_.links.size()) - 1;
  }

  const LinkReport& parent_of(const LinkReport& link) const {
    return report_.links[static_cast<std::size_t>(link.parent)];
  }

  void add_inertial(const Link& link, LinkReport& result) {
    moves_in_world_.push_back(
        result.moves ||
        (result.parent >= 0 && moves_in_world_[static_cast<std::size_t>(result.parent)]));
    if (!link.inertial) return;
    result.has_inertial = true;
    result.mass = link.inertial->mass;
    result.com = link.inertial->origin.xyz;
    result.moments = principal_moments(*link.inertial);
    result.unphysical = find_unphysical(*link.inertial);
    report_.mass += result.mass;
    if (moves_in_world_.back()) report_.moving_mass += result.mass;
  }

  void add_joint(std::size_t index, LinkReport& link) {
    const Joint& joint = robot_.joints[index];
    link.depth = parent_of(link).depth + 1;
    link.joint = joint.name;
    link.joint_type = joint_type_name(joint.type);
    link.motion = link.joint_type;
    if (!info_of(joint.type).moves()) return;
    const int owner = joint.mimic ? joint.mimic->joint : static_cast<int>(index);
    const auto locked = scene_.locked.find(robot_.joints[static_cast<std::size_t>(owner)].name);
    if (locked != scene_.locked.end()) {
      const double at = joint.mimic ? joint.mimic->multiplier * locked->second + joint.mimic->offset
                                    : locked->second;
      link.motion = fmt::format("locked at {} {}", at, unit_of(joint.type));
      return;
    }
    link.moves = true;
    if (joint.mimic) link.motion = fmt::format("{}, follows", link.joint_type);
    number_joint(index, joint);
  }

  void number_joint(std::size_t index, const Joint& joint) {
    JointReport result;
    result.name = joint.name;
    result.type = joint_type_name(joint.type);
    result.unit = unit_of(joint.type);
    if (joint.limits) {
      result.lower = joint.limits->lower;
      result.upper = joint.limits->upper;
      result.effort = joint.limits->effort;
      result.velocity = joint.limits->velocity;
    }
    result.drive = drive_of(joint.name);
    result.nv = info_of(joint.type).freedoms();
    result.nq = info_of(joint.type).positions();
    if (joint.mimic) {
      result.follows = describe(*joint.mimic, robot_);
      followers_.emplace_back(report_.joints.size(), joint.mimic->joint);
    } else {
      append(result);
    }
    place_[static_cast<int>(index)] = report_.joints.size();
    report_.joints.push_back(result);
  }

  [[nodiscard]] std::optional<DriveReport> drive_of(const std::string& joint) const {
    DriveReport drive;
    if (const auto own = scene_.armature.find(joint); own != scene_.armature.end()) {
      drive.rotor = own->second;
    }
    if (const auto own = scene_.joint_friction.find(joint); own != scene_.joint_friction.end()) {
      drive.damping = own->second.damping;
      drive.friction = own->second.friction;
      drive.width = drive.friction > 0 ? own->second.width : 0;
    }
    if (const auto own = scene_.joint_springs.find(joint); own != scene_.joint_springs.end()) {
      drive.stiffness = own->second.stiffness;
      drive.rest = own->second.rest;
    }
    const bool any = drive.rotor + drive.damping + drive.friction + drive.stiffness > 0;
    return any ? std::optional(drive) : std::nullopt;
  }

  void append(JointReport& joint) {
    joint.q = report_.nq;
    joint.v = report_.nv;
    report_.nq += joint.nq;
    report_.nv += joint.nv;
  }

  void add_floating_base() {
    JointReport base;
    base.name = "floating base";
    base.type = "floating";
    base.nq = 7;
    base.nv = 6;
    append(base);
    report_.joints.push_back(base);
  }

  void number_mimics() {
    for (const auto& [follower, joint] : followers_) {
      const JointReport& leader = report_.joints[place_.at(joint)];
      report_.joints[follower].q = leader.q;
      report_.joints[follower].v = leader.v;
    }
  }

  const Robot& robot_;
  const Scene& scene_;
  Report& report_;
  std::vector<bool> moves_in_world_;
  std::map<int, std::size_t> place_;  ///< by joint of the robot: its index in Report::joints
  std::vector<std::pair<std::size_t, int>> followers_;
};

PointReport inspect_point(const ScenePoint& point) {
  return {point.name, point.center_of_mass ? kCenterOfMass : point.link,
          point.axes == Axes::world ? "world" : "local", list_rows(point)};
}

int count_nonzero(const Inertia& inertia) {
  const auto nonzero = [](const Digits50& x) { return x != 0 ? 1 : 0; };
  int number = nonzero(inertia.mass);
  for (int i = 0; i < 3; ++i) {
    number += nonzero(inertia.h[i]);
    for (int j = i; j < 3; ++j) number += nonzero(inertia.Sigma(i, j));
  }
  return number;
}

void inspect_reductions(const Robot& robot, const Scene& scene, Report& report) {
  const Mechanism before = build_mechanism(robot, scene);
  const Mechanism after = reduced_mechanism(robot, scene);
  for (std::size_t i = 0; i < before.links.size(); ++i) {
    const Inertia& a = before.links[i].inertia;
    const Inertia& b = after.links[i].inertia;
    report.reductions.push_back({before.links[i].name, static_cast<double>(a.mass),
                                 static_cast<double>(b.mass), count_nonzero(a), count_nonzero(b)});
  }
  for (const ReductionNote& note : after.notes) {
    report.notes.push_back({note.step, note.link, note.text});
  }
}

}  // namespace

Report inspect_robot(const Robot& robot, const std::optional<Scene>& given) {
  Scene scene = given.value_or(Scene{});
  if (!given) scene.base = default_base(robot);
  Report report;
  report.robot = robot.name;
  report.urdf = robot.file;
  report.scene = scene.file;
  report.base = scene.base == Base::floating ? "floating" : "fixed";
  report.gravity = scene.gravity;
  Walk(robot, scene, report).visit_all();
  for (const ScenePoint& point : scene.operational_points) {
    report.operational_points.push_back(inspect_point(point));
  }
  for (const ScenePoint& point : scene.external_forces) {
    report.external_forces.push_back(inspect_point(point));
    report.external_forces.back().rows.clear();
  }
  inspect_inertias(robot, scene, report);
  inspect_masses(robot, scene, report);
  inspect_risks(robot, scene, report);
  inspect_loops(robot, scene, report);
  if (report.nv > 0) inspect_reductions(robot, scene, report);
  return report;
}

}  // namespace treeline
