#pragma once

#include <optional>
#include <string>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "inspect/report.hpp"

namespace treeline {

/// Describes a robot in a scene. Without a scene the base is fixed and nothing is locked.
Report inspect_robot(const Robot& robot, const std::optional<Scene>& scene);

/// Prints what the robot is, in ten lines for people.
std::string print_summary(const Report& report);

/// Prints the summary, then the whole report as aligned columns with units, within 100 columns.
std::string print_text(const Report& report);

/// Prints every field of the report as JSON, for programs. Infinite limits are null.
std::string print_json(const Report& report);

/// Prints the tree for Graphviz: links are boxes, joints are edges, dashed if they do not move,
/// dotted for mimics. Boxes of impossible inertias are red.
std::string print_dot(const Report& report);

}  // namespace treeline
