#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "description/flat/flat_model.hpp"
#include "description/flat/made_names.hpp"
#include "description/read_number.hpp"
#include "description/rotation.hpp"

namespace treeline {
namespace {

constexpr double kOfProducts = 2e-15;  ///< of angles after a few products of rotations, rad

/// Text of three numbers, without the sign of a zero.
std::string three(const Eigen::Vector3d& v) {
  return fmt::format("{} {} {}", v.x() + 0.0, v.y() + 0.0, v.z() + 0.0);
}

/// A bound as every reader of URDF takes it: urdfdom, by which ROS and Pinocchio read, refuses a
/// joint with "inf".
std::string bound(double value) {
  return fmt::format("{}", std::clamp(value, -kLargestNumber, kLargestNumber));
}

/// Whether a joint's frame is its child's: then the child hangs on the joint itself.
bool is_identity(const Eigen::Isometry3d& pose, double length) {
  return pose.linear().isIdentity(kOfProducts) &&
         pose.translation().cwiseAbs().maxCoeff() <= kOfProducts * length;
}

class UrdfPrinter {
 public:
  UrdfPrinter(const FlatModel& model, const FlatTree& tree) : model_(model), tree_(tree) {
    for (const FlatLink& link : model.links) names_.take(link.name);
    for (const auto* joints : {&model.joints, &tree.joints, &tree.loops}) {
      for (const FlatJoint& joint : *joints) joint_names_.take(joint.name);
    }
    if (tree.has_world) world_ = names_.make("world");
  }

  std::string run() {
    printer_.OpenElement("robot");
    printer_.PushAttribute("name", model_.name.c_str());
    if (tree_.has_world) open_link(world_);
    if (tree_.has_world) printer_.CloseElement();
    for (const FlatLink& link : model_.links) print_link(link);
    for (const FlatJoint& joint : tree_.joints) print_joint(joint);
    for (const FlatJoint& loop : tree_.loops) print_loop(loop);
    printer_.CloseElement();
    return std::string(printer_.CStr()) + "\n";
  }

 private:
  [[nodiscard]] std::string name_of(int link) const {
    return link < 0 ? world_ : model_.links[static_cast<std::size_t>(link)].name;
  }

  void attribute(const char* name, const std::string& value) {
    printer_.PushAttribute(name, value.c_str());
  }

  void open_link(const std::string& name) {
    printer_.OpenElement("link");
    attribute("name", name);
  }

  /// Components that are zero but for rounding are made so, and rotations by quarter turns exact.
  void print_pose(const Eigen::Isometry3d& pose) {
    const auto clean = [](double x, double resolution) {
      return std::abs(x) <= resolution ? 0.0 : x;
    };
    Eigen::Matrix3d R = pose.linear();
    for (double& entry : R.reshaped()) {
      entry = clean(entry, kOfProducts);
      if (std::abs(std::abs(entry) - 1) <= kOfProducts) entry = std::copysign(1.0, entry);
    }
    Eigen::Vector3d p = pose.translation();
    for (double& entry : p) entry = clean(entry, kOfProducts * model_.length);
    const auto rpy = rpy_from_rotation(R);
    attribute("xyz", three(p));
    attribute("rpy", three({rpy[0], rpy[1], rpy[2]}));
  }

  void print_origin(const Eigen::Isometry3d& pose) {
    printer_.OpenElement("origin");
    print_pose(pose);
    printer_.CloseElement();
  }

  void print_inertial(const FlatInertial& inertial) {
    printer_.OpenElement("inertial");
    print_origin(inertial.pose);
    printer_.OpenElement("mass");
    attribute("value", fmt::format("{}", inertial.mass));
    printer_.CloseElement();
    printer_.OpenElement("inertia");
    attribute("ixx", fmt::format("{}", inertial.ixx));
    attribute("ixy", fmt::format("{}", inertial.ixy));
    attribute("ixz", fmt::format("{}", inertial.ixz));
    attribute("iyy", fmt::format("{}", inertial.iyy));
    attribute("iyz", fmt::format("{}", inertial.iyz));
    attribute("izz", fmt::format("{}", inertial.izz));
    printer_.CloseElement();
    printer_.CloseElement();
  }

  void print_shape(const FlatShape& shape) {
    printer_.OpenElement(shape.collides ? "collision" : "visual");
    print_origin(shape.pose);
    printer_.OpenElement("geometry");
    printer_.OpenElement(shape.kind.c_str());
    attribute(shape.size_name.c_str(), shape.size);
    if (!shape.more_name.empty()) attribute(shape.more_name.c_str(), shape.more);
    printer_.CloseElement();
    printer_.CloseElement();
    if (!shape.color.empty()) {
      printer_.OpenElement("material");
      attribute("name", shape.color);
      printer_.OpenElement("color");
      attribute("rgba", shape.color);
      printer_.CloseElement();
      printer_.CloseElement();
    }
    printer_.CloseElement();
  }

  void print_link(const FlatLink& link) {
    open_link(link.name);
    if (link.inertial) print_inertial(*link.inertial);
    for (const FlatShape& shape : link.shapes) print_shape(shape);
    printer_.CloseElement();
  }

  void print_ends(const std::string& parent, const std::string& child) {
    printer_.OpenElement("parent");
    attribute("link", parent);
    printer_.CloseElement();
    printer_.OpenElement("child");
    attribute("link", child);
    printer_.CloseElement();
  }

  void open_joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child, const Eigen::Isometry3d& origin) {
    printer_.OpenElement("joint");
    attribute("name", name);
    attribute("type", type);
    print_ends(parent, child);
    print_origin(origin);
  }

  void print_direction(const FlatAxis& axis) {
    Eigen::Vector3d direction = axis.direction;
    for (double& entry : direction) entry = std::abs(entry) <= kOfProducts ? 0 : entry;
    printer_.OpenElement("axis");
    attribute("xyz", three(direction));
    printer_.CloseElement();
  }

  void print_axis(const FlatAxis& axis, bool turns_on) {
    print_direction(axis);
    printer_.OpenElement("limit");
    if (!turns_on) {
      attribute("lower", bound(axis.lower));
      attribute("upper", bound(axis.upper));
    }
    attribute("effort", bound(axis.effort));
    attribute("velocity", bound(axis.velocity));
    printer_.CloseElement();
    if (axis.damping == 0 && axis.friction == 0 && axis.armature == 0) return;
    printer_.OpenElement("dynamics");
    attribute("damping", fmt::format("{}", axis.damping));
    attribute("friction", fmt::format("{}", axis.friction));
    if (axis.armature != 0) attribute("armature", fmt::format("{}", axis.armature));
    printer_.CloseElement();
  }

  void print_mimic(const FlatMimic& mimic) {
    printer_.OpenElement("mimic");
    attribute("joint", mimic.joint);
    attribute("multiplier", fmt::format("{}", mimic.multiplier));
    attribute("offset", fmt::format("{}", mimic.offset));
    printer_.CloseElement();
  }

  void print_rotor(const FlatJoint& joint) {
    for (const auto& [name, value] : joint.rotor) {
      printer_.OpenElement(name.c_str());
      attribute("value", value);
      printer_.CloseElement();
    }
  }

  /// Writes a turning joint without its end: the caller writes `</joint>`.
  void open_turning(const std::string& name, const std::string& type, const FlatAxis& axis,
                    const std::string& parent, const std::string& child,
                    const Eigen::Isometry3d& origin) {
    const bool turns_on = type != "prismatic" && std::isinf(axis.lower) && std::isinf(axis.upper);
    const std::string as = type == "prismatic" ? type : turns_on ? "continuous" : "revolute";
    open_joint(name, as, parent, child, origin);
    print_axis(axis, turns_on);
  }

  void print_joint(const FlatJoint& joint) {
    const Eigen::Isometry3d to_child = joint.in_child.inverse();
    const std::string parent = name_of(joint.parent), child = name_of(joint.child);
    if (joint.type == "fixed") {
      open_joint(joint.name, "fixed", parent, child, joint.in_parent * to_child);
      printer_.CloseElement();
      return;
    }
    const bool direct = is_identity(to_child, model_.length);
    const std::string end = direct ? child : names_.make(joint.name + "_frame");
    if (joint.axes.size() == 2) {
      print_two(joint, parent, end);
    } else if (joint.axes.empty()) {
      open_joint(joint.name, joint.type == "floating" ? "floating" : "ball", parent, end,
                 joint.in_parent);
      printer_.CloseElement();
    } else {
      open_turning(joint.name, joint.type, joint.axes[0], parent, end, joint.in_parent);
      print_rotor(joint);
      if (joint.mimic) print_mimic(*joint.mimic);
      printer_.CloseElement();
    }
    if (direct) return;
    open_link(end);
    printer_.CloseElement();
    open_joint(joint_names_.make(joint.name + "_to_" + child), "fixed", end, child, to_child);
    printer_.CloseElement();
  }

  void print_two(const FlatJoint& joint, const std::string& parent, const std::string& end) {
    const std::string between = names_.make(joint.name + "_cross");
    open_link(between);
    printer_.CloseElement();
    open_turning(joint_names_.make(joint.name + "_1"), "revolute", joint.axes[0], parent, between,
                 joint.in_parent);
    printer_.CloseElement();
    open_turning(joint_names_.make(joint.name + "_2"), "revolute", joint.axes[1], between, end,
                 Eigen::Isometry3d::Identity());
    printer_.CloseElement();
  }

  void print_loop_end(const char* name, int link, const Eigen::Isometry3d& pose) {
    printer_.OpenElement(name);
    attribute("link", name_of(link));
    print_pose(pose);
    printer_.CloseElement();
  }

  void print_loop(const FlatJoint& joint) {
    printer_.OpenElement("loop_joint");
    attribute("name", joint.name);
    attribute("type", joint.type == "ball" ? "spherical" : joint.type);
    if (!joint.axes.empty()) print_direction(joint.axes[0]);
    print_loop_end("link1", joint.parent, joint.in_parent);
    print_loop_end("link2", joint.child, joint.in_child);
    printer_.CloseElement();
  }

  const FlatModel& model_;
  const FlatTree& tree_;
  tinyxml2::XMLPrinter printer_;
  MadeNames names_, joint_names_;
  std::string world_;
};

}  // namespace

std::string print_urdf(const FlatModel& model, const FlatTree& tree) {
  return UrdfPrinter(model, tree).run();
}

}  // namespace treeline
