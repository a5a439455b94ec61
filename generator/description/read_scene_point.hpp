#pragma once

#include <array>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// A pose: optional xyz and rpy.
Pose read_origin(const SceneElement& element);

/// The key `name` of a map's `fields`. An error if it is missing or no identifier.
std::string read_point_name(const SceneElement& element, const SceneFields& fields);
/// The name of a link of the robot, as it is written; an error where the robot has none of it.
std::string read_known_link(const SceneElement& element, const Robot& robot);
Axes read_axes(const SceneElement& element);
/// A list of some of x y z rx ry rz, in this order.
std::array<bool, 6> read_rows(const SceneElement& element);

/// One item, or a list of items.
std::vector<SceneElement> one_or_more(const SceneElement& element);

/// Whether a name is among those.
bool contains(const std::vector<std::string>& names, const std::string& name);

/// The link of that name; null, and an error, where the robot has none, or one that cannot move in
/// the scene.
const Link* find_moving_link(const SceneElement& element, const std::string& name,
                             const Robot& robot, const Scene& scene);

/// The scene's lists of frames on links. Names must be identifiers and differ within a list.
std::vector<ScenePoint> read_operational_points(const SceneElement& element, const Robot& robot);
std::vector<ScenePoint> read_external_forces(const SceneElement& element, const Robot& robot);
std::vector<ScenePoint> read_contacts(const SceneElement& element, const Robot& robot);

/// The joint of that name; null, and an error with a suggestion, where the robot has none.
const Joint* find_joint(const SceneElement& element, const std::string& name, const Robot& robot);

/// The scene's map from joints to the values they are held at. An error for a joint that is
/// unknown, fixed, mimic or of several degrees of freedom; a warning for a value outside the
/// joint's limits.
void read_locked(const SceneElement& element, const Robot& robot, Scene& scene);

/// The scene's list of joints without a motor. An error for a joint that is unknown, fixed, locked
/// or mimic.
void read_passive(const SceneElement& element, const Robot& robot, Scene& scene);

}  // namespace treeline
