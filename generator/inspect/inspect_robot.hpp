#pragma once

#include <optional>
#include <string>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "inspect/report.hpp"

namespace treeline {

/// What there is to say of a robot in a scene; without one, with a fixed base and nothing locked.
Report inspect_robot(const Robot& robot, const std::optional<Scene>& scene);

/// For people: what the robot is, in ten lines.
std::string print_summary(const Report& report);

/// The summary, then all there is as aligned columns with units, within 100 columns.
std::string print_text(const Report& report);

/// For programs: every field of the report by its name, infinite bounds as null.
std::string print_json(const Report& report);

/// For Graphviz: links as boxes, joints as edges; dashed where nothing moves, dotted for mimics,
/// red boxes for inertias that are not physical.
std::string print_dot(const Report& report);

}  // namespace treeline
