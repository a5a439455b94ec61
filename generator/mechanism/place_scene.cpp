#include <algorithm>
#include <optional>
#include <set>

#include "description/rotation.hpp"
#include "mechanism/build_steps.hpp"
#include "mechanism/digits50_from_file.hpp"
#include "mechanism/resolution.hpp"

namespace treeline {
namespace {

/// Index of what has this name; readers have checked that there is one.
template <class Named>
std::size_t index_of(const std::vector<Named>& all, const std::string& name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Named& each) { return each.name == name; });
  return static_cast<std::size_t>(found - all.begin());
}

const LinkPlace& place_of(const PlacedRobot& placed, const std::string& link) {
  return placed.links[index_of(placed.robot.links, link)];
}

MechanismPoint point(const PlacedRobot& placed, const ScenePoint& wanted, Mechanism& mechanism) {
  if (wanted.center_of_mass) {
    return {wanted.name, -1, {}, wanted.axes, wanted.rows, wanted.priority, true};
  }
  const LinkPlace& place = place_of(placed, wanted.link);
  const Digits50Pose pose =
      resolved_as(place.pose * digits50_pose(wanted.origin), wanted.name, mechanism);
  return {wanted.name, place.link, pose, wanted.axes, wanted.rows, wanted.priority};
}

std::vector<MechanismPoint> points(const PlacedRobot& placed, const std::vector<ScenePoint>& wanted,
                                   Mechanism& mechanism) {
  std::vector<MechanismPoint> result;
  for (const ScenePoint& each : wanted) result.push_back(point(placed, each, mechanism));
  return result;
}

/// A frame on a link, or on the world where `SceneLoop` permits it.
MechanismPoint loop_end(const PlacedRobot& placed, const ScenePoint& wanted, Mechanism& mechanism) {
  if (wanted.link != kWorldEnd) return point(placed, wanted, mechanism);
  const Digits50Pose pose = resolved_as(digits50_pose(wanted.origin), wanted.name, mechanism);
  return {wanted.name, -1, pose, wanted.axes, wanted.rows, wanted.priority};
}

std::optional<MechanismRolling> rolling(const SceneLoop& loop) {
  if (!loop.rolling) return std::nullopt;
  MechanismRolling rolling{loop.rolling->radius, {}, loop.rolling->on_radius};
  if (loop.rolling->axis) rolling.axis = unit_axis<Digits50>(*loop.rolling->axis);
  return rolling;
}

std::vector<MechanismLoop> loops(const PlacedRobot& placed, Mechanism& mechanism) {
  std::vector<MechanismLoop> result;
  for (const SceneLoop& loop : placed.scene.loops) {
    const MechanismPoint first = point(placed, loop.first, mechanism);
    result.push_back({first, loop_end(placed, loop.second, mechanism), rolling(loop)});
  }
  return result;
}

std::vector<MechanismCoupling> couplings(const PlacedRobot& placed) {
  std::vector<MechanismCoupling> result;
  for (const SceneCoupling& coupling : placed.scene.couplings) {
    result.push_back({coupling.name, {}, coupling.offset});
    for (const auto& [name, factor] : coupling.parts) {
      const FirstCoordinate first = placed.joints[index_of(placed.robot.joints, name)];
      result.back().parts.push_back({first.q, first.v, factor});
    }
  }
  return result;
}

/// Frames of all links of the URDF.
std::vector<MechanismPoint> files_frames(const PlacedRobot& placed) {
  std::vector<MechanismPoint> frames;
  for (std::size_t i = 0; i < placed.links.size(); ++i) {
    frames.push_back({placed.robot.links[i].name, placed.links[i].link, placed.links[i].pose});
  }
  return frames;
}

/// Velocities of floating joints and of those that the scene calls passive.
std::vector<int> passive_velocities(const Scene& scene, const Mechanism& mechanism) {
  std::set<int> velocities;
  for (const MovingLink& link : mechanism.links) {
    const bool named = std::count(scene.passive.begin(), scene.passive.end(), link.joint) > 0;
    if (!link.is_floating() && !named) continue;
    for (int k = 0; k < link.velocities(); ++k) velocities.insert(link.v_index + k);
  }
  return {velocities.begin(), velocities.end()};
}

/// Frames of moving links with the names of their URDF links. The inner links of a joint of several
/// axes have other names.
std::vector<MechanismPoint> link_frames(const PlacedRobot& placed, const Mechanism& mechanism) {
  std::vector<MechanismPoint> frames;
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
    if (mechanism.links[i].spins) continue;  // no frame of the URDF
    for (std::size_t k = 0; k < placed.links.size(); ++k) {
      const LinkPlace& place = placed.links[k];
      const std::string& name = placed.robot.links[k].name;
      if (place.link != static_cast<int>(i) || name != mechanism.links[i].name) continue;
      frames.push_back(
          {name, place.link, place.pose, Axes::local, {true, true, true, true, true, true}});
    }
  }
  return frames;
}

/// Frames of the links to which regressors add a body.
std::vector<MechanismPoint> payload_frames(const PlacedRobot& placed) {
  std::vector<MechanismPoint> frames;
  for (const std::string& link : placed.scene.regressor.payloads) {
    const LinkPlace& place = place_of(placed, link);
    frames.push_back({link, place.link, place.pose, Axes::local});
  }
  return frames;
}

std::vector<MechanismObject> objects(const Scene& scene, const Resolution& resolution) {
  std::vector<MechanismObject> result;
  for (const SceneObject& object : scene.objects) {
    result.push_back({object.name, resolved(digits50_inertia(object.inertial), resolution), {}});
    for (const SceneGrasp& grasp : object.grasps) {
      result.back().grasps.push_back({index_of(scene.operational_points, grasp.point),
                                      resolved(digits50_pose(grasp.origin), resolution)});
    }
  }
  return result;
}

}  // namespace

Digits50Pose resolved_as(const Digits50Pose& pose, const std::string& element,
                         Mechanism& mechanism) {
  Change change;
  const Digits50Pose result = resolved(pose, mechanism.resolution, &change);
  add_decisions(change, element, mechanism.file, mechanism.noise);
  return result;
}

void place_scene(const PlacedRobot& placed, Mechanism& mechanism) {
  const Scene& scene = placed.scene;
  mechanism.operational_points = points(placed, scene.operational_points, mechanism);
  mechanism.external_forces = points(placed, scene.external_forces, mechanism);
  mechanism.objects = objects(scene, mechanism.resolution);
  mechanism.contacts = points(placed, scene.contacts, mechanism);
  mechanism.constraints = points(placed, scene.constraints, mechanism);
  mechanism.loops = loops(placed, mechanism);
  mechanism.couplings = couplings(placed);
  mechanism.passive = passive_velocities(scene, mechanism);
  mechanism.link_frames = link_frames(placed, mechanism);
  mechanism.regressor = scene.regressor;
  mechanism.payload_frames = payload_frames(placed);
  mechanism.inputs = place_inputs(placed.robot, scene, files_frames(placed));
}

}  // namespace treeline
