#include "robots.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "description/read_urdf.hpp"

namespace treeline::stress {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

ScenePoint point_on(const std::string& name, const std::string& link, double offset) {
  ScenePoint point;
  point.name = name;
  point.link = link;
  point.origin.xyz = {offset, 0.1 * offset, 0};
  return point;
}

/// A solid rod along x.
Inertial rod(double mass, double length, double radius) {
  Inertial inertial;
  inertial.mass = mass;
  inertial.origin.xyz = {0.5 * length, 0.1 * length, 0};
  inertial.ixx = 0.5 * mass * radius * radius;
  inertial.iyy = mass * (3 * radius * radius + length * length) / 12;
  inertial.izz = inertial.iyy;
  return inertial;
}

Inertial ball(double mass, double radius) {
  Inertial inertial;
  inertial.mass = mass;
  inertial.ixx = inertial.iyy = inertial.izz = 0.4 * mass * radius * radius;
  return inertial;
}

Joint joint_to(int link, int parent, double length) {
  Joint joint;
  joint.name = fmt::format("joint_{}", link);
  joint.type = JointType::revolute;
  joint.parent = parent;
  joint.child = link;
  joint.origin.xyz = {parent == 0 ? 0 : length, 0, 0};
  joint.axis = link % 2 == 0 ? std::array{0.0, 1.0, 0.0} : std::array{0.0, 0.0, 1.0};
  return joint;
}

}  // namespace

Case make_arm(const ArmOptions& o) {
  Case made;
  made.robot.name = "arm";
  made.robot.root = 0;
  made.robot.links.push_back({"base", {}, 0});
  if (o.floating) made.robot.links[0].inertial = rod(o.mass, o.length, o.slenderness * o.length);
  for (int i = 1; i <= o.links; ++i) {
    const double mass = o.mass * std::pow(o.mass_growth, i - 1) * (i == o.light_link ? o.light : 1);
    Link link{fmt::format("link_{}", i), {}, 0};
    const double radius = o.slenderness * o.length;
    if (mass > 0) link.inertial = o.balls ? ball(mass, radius) : rod(mass, o.length, radius);
    made.robot.links.push_back(link);
    const int parent = o.binary_tree && i > 1 ? i / 2 : (i == 1 ? 0 : i - 1);
    made.robot.joints.push_back(joint_to(i, parent, o.length));
  }
  made.scene.name = "arm";
  made.scene.base = o.floating ? Base::floating : Base::fixed;
  made.scene.singular = SingularTasks::exact;  // the plain solves are tested
  made.scene.operational_points = {point_on("tip", made.robot.links.back().name, o.length)};
  if (o.binary_tree && o.links > 2) {
    int leaf = 1;
    while (2 * leaf <= o.links) leaf *= 2;
    made.scene.operational_points.push_back(
        point_on("other", made.robot.links[at(leaf)].name, o.length));
  }
  return made;
}

Case read_robot(const std::string& urdf, const std::string& link) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(urdf, diagnostics);
  if (!robot) throw std::runtime_error("cannot read " + urdf);
  Case made{*robot, {}};
  made.scene.name = "robot";
  made.scene.singular = SingularTasks::exact;
  made.scene.operational_points = {point_on("tool", link, 0)};
  return made;
}

}  // namespace treeline::stress
