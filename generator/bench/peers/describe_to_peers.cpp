#include "bench/peers/describe_to_peers.hpp"

#include <algorithm>

#include "description/rotation.hpp"
#include "description/scene_inputs.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline {
namespace {

PeerPoint point_of(const ScenePoint& from) {
  PeerPoint point{from.link, {}, from.origin.xyz, from.rows, from.axes == Axes::world};
  using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  Eigen::Map<Rows>(point.R.data()) = rotation_from_rpy<double>(from.origin.rpy);
  return point;
}

/// Whether a body other than the base has a joint of this kind.
bool has_joints_of(const interpreter::Model<double>& model, interpreter::JointKind kind) {
  return std::any_of(model.bodies.begin() + 1, model.bodies.end(),
                     [kind](const auto& body) { return body.kind == kind; });
}

}  // namespace

std::optional<PeerDescription> describe_to_peers(const Robot& robot, const Scene& scene,
                                                 std::string& why_not) {
  if (!scene.armature.empty() || !scene.rotors.empty() || !scene.joint_friction.empty() ||
      !scene.joint_springs.empty()) {
    why_not = "the scene adds rotors, friction or springs to joints";
    return std::nullopt;
  }
  if (has_center_of_mass(scene)) {
    why_not = "an operational point is the centre of mass";
    return std::nullopt;
  }
  const auto model = model_from_robot<double>(robot, scene);
  if (model.has_mimics()) {
    why_not = "the robot has joints that mimic others";
    return std::nullopt;
  }
  if (has_joints_of(model, interpreter::JointKind::planar) ||
      has_joints_of(model, interpreter::JointKind::floating) ||
      has_joints_of(model, interpreter::JointKind::spherical)) {
    why_not = "the robot has planar, floating or ball joints";
    return std::nullopt;
  }
  PeerDescription description{scene.base == Base::floating, scene.gravity, {}, {}};
  for (const auto& body : model.bodies) {
    description.links.insert(description.links.end(),
                             static_cast<std::size_t>(interpreter::velocity_count(body.kind)),
                             body.name);
  }
  for (const ScenePoint& point : scene.operational_points) {
    description.points.push_back(point_of(point));
  }
  for (const ScenePoint& held : scene.constraints) {
    description.constraints.push_back({held.name, point_of(held), std::nullopt});
  }
  for (const SceneLoop& loop : scene.loops) {
    if (loop.rolling) continue;
    PeerPoint frame = point_of(loop.first);
    frame.rows = loop.second.rows;
    description.constraints.push_back({loop.first.name, frame, point_of(loop.second)});
  }
  return description;
}

}  // namespace treeline
