#include "mechanism/add_drives.hpp"

namespace treeline {
namespace {

/// Value of a joint in the map; nothing by default.
template <class Value>
Value value_of(const std::map<std::string, Value>& values, const std::string& joint) {
  const auto found = values.find(joint);
  return found == values.end() ? Value{} : found->second;
}

JointDrive drive_of(const MovingLink& link, const Scene& scene) {
  const Digits50 m = link.multiplier;
  const SceneFriction friction = value_of(scene.joint_friction, link.joint);
  const SceneSpring spring = value_of(scene.joint_springs, link.joint);
  JointDrive drive;
  drive.inertia = m * m * Digits50(value_of(scene.armature, link.joint));
  drive.damping = m * m * Digits50(friction.damping);
  if (friction.friction > 0) {
    drive.friction = m * Digits50(friction.friction);
    drive.sharpness = m / Digits50(friction.width);
  }
  if (spring.stiffness > 0 && m != 0) {
    drive.stiffness = m * m * Digits50(spring.stiffness);
    drive.rest = (Digits50(spring.rest) - link.offset) / m;
  }
  return drive;
}

}  // namespace

void add_drives(const Scene& scene, Mechanism& mechanism) {
  for (MovingLink& link : mechanism.links) link.drive = drive_of(link, scene);
}

}  // namespace treeline
