#pragma once

#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "packaging/describe_package.hpp"
#include "packaging/package_kind.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Files that make a package of ROS 2 of the code: a plugin of ros2_control whose law is the
/// scene's controller or, without one, gravity compensation.
std::vector<PackageFolder> for_ros2_control(PackageFacts facts, const Robot& robot,
                                            const Scene& scene, const Generation& generation);

/// Refuses what such a plugin has no interface for: measured forces, inputs, and without a
/// controller what else than one coordinate with a motor each joint is.
void refuse_for_ros2_control(const Robot& robot, const Scene& scene, Diagnostics& diagnostics);

}  // namespace treeline
