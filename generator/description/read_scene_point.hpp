#pragma once

#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// A pose: optional xyz and rpy.
Pose read_origin(const SceneElement& element);

/// The scene's lists of frames on links. Names must be identifiers and differ within a list.
std::vector<ScenePoint> read_operational_points(const SceneElement& element, const Robot& robot);
std::vector<ScenePoint> read_external_forces(const SceneElement& element, const Robot& robot);
std::vector<ScenePoint> read_contacts(const SceneElement& element, const Robot& robot);
/// Frames of which rows are held relative to the world: `between: [link, world]`.
std::vector<ScenePoint> read_constraints(const SceneElement& element, const Robot& robot);

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
