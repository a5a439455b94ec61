#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "bench/peers/describe_to_peers.hpp"
#include "description/noise.hpp"
#include "description/rotation.hpp"
#include "report/svg.hpp"

namespace treeline {
namespace {

using report::escape_xml;

std::string print(const std::array<double, 3>& x) {
  return fmt::format("{} {} {}", x[0], x[1], x[2]);
}

std::string print(const Pose& pose) {
  return fmt::format("<origin xyz=\"{}\" rpy=\"{}\"/>", print(pose.xyz), print(pose.rpy));
}

std::string print(const Link& link) {
  if (!link.inertial) return fmt::format("  <link name=\"{}\"/>\n", escape_xml(link.name));
  const Inertial& I = *link.inertial;
  return fmt::format(
      "  <link name=\"{}\">\n    <inertial>{}<mass value=\"{}\"/>\n"
      "      <inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" izz=\"{}\"/>\n"
      "    </inertial>\n  </link>\n",
      escape_xml(link.name), print(I.origin), I.mass, I.ixx, I.ixy, I.ixz, I.iyy, I.iyz, I.izz);
}

/// Value at which the scene holds a joint, directly or through the joint that it mimics.
std::optional<double> held_at(const Robot& robot, const Scene& scene, const Joint& joint) {
  if (const auto own = scene.locked.find(joint.name); own != scene.locked.end()) return own->second;
  if (!joint.mimic) return std::nullopt;
  const Joint& leader = robot.joints[static_cast<std::size_t>(joint.mimic->joint)];
  const auto locked = scene.locked.find(leader.name);
  if (locked == scene.locked.end()) return std::nullopt;
  return joint.mimic->multiplier * locked->second + joint.mimic->offset;
}

/// Displacement of a joint of one degree of freedom, as a pose.
Pose displacement(const Joint& joint, double at) {
  const Eigen::Vector3d axis = Eigen::Map<const Eigen::Vector3d>(joint.axis.data()).normalized();
  Pose pose;
  if (joint.type == JointType::prismatic) {
    Eigen::Map<Eigen::Vector3d>(pose.xyz.data()) = at * axis;
    return pose;
  }
  const Eigen::Matrix3d R = Eigen::AngleAxisd(at, axis).toRotationMatrix();
  pose.rpy = {std::atan2(R(2, 1), R(2, 2)), std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0))),
              std::atan2(R(1, 0), R(0, 0))};
  return pose;
}

class Printer {
 public:
  Printer(const Robot& robot, const Scene& scene) : robot_(as_asked(robot, scene)), scene_(scene) {}

  std::string print() const {
    std::string text =
        fmt::format("<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n", escape_xml(robot_.name));
    for (const Link& link : robot_.links) text += treeline::print(link);
    for (const Joint& joint : robot_.joints) text += print(joint);
    return text + "</robot>\n";
  }

 private:
  [[nodiscard]] const std::string& link(int i) const {
    return robot_.links[static_cast<std::size_t>(i)].name;
  }

  static std::string head(const std::string& name, const char* type, const std::string& parent,
                          const std::string& child, const Pose& origin) {
    return fmt::format(
        "  <joint name=\"{}\" type=\"{}\">\n    <parent link=\"{}\"/><child link=\"{}\"/>\n    "
        "{}\n",
        escape_xml(name), type, escape_xml(parent), escape_xml(child), treeline::print(origin));
  }

  [[nodiscard]] std::string print(const Joint& joint) const {
    const std::string& parent = link(joint.parent);
    const std::string& child = link(joint.child);
    if (const auto at = held_at(robot_, scene_, joint)) {
      const std::string between = joint.name + " where it is held";
      return fmt::format("  <link name=\"{}\"/>\n", escape_xml(between)) +
             head(joint.name, "fixed", parent, between, joint.origin) + "  </joint>\n" +
             head(between, "fixed", between, child, displacement(joint, *at)) + "  </joint>\n";
    }
    const bool moves = joint.type != JointType::fixed;
    const char* const type =
        joint_type_name(joint.type == JointType::continuous ? JointType::revolute : joint.type);
    std::string text = head(joint.name, type, parent, child, joint.origin);
    if (moves)
      text += fmt::format("    <axis xyz=\"{}\"/>\n{}", treeline::print(joint.axis), kNoLimit);
    return text + "  </joint>\n";
  }

  /// Limits do not matter. But a revolute joint without limits would be a continuous one, for which
  /// some libraries have other coordinates.
  static constexpr const char* kNoLimit =
      "    <limit lower=\"-1e9\" upper=\"1e9\" effort=\"1e9\" velocity=\"1e9\"/>\n";

  const Robot robot_;
  const Scene& scene_;
};

}  // namespace

std::string print_plain_urdf(const Robot& robot, const Scene& scene) {
  return Printer(robot, scene).print();
}

}  // namespace treeline
