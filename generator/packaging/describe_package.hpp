#pragma once

#include <map>
#include <string>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

/// What the templates of packages may say of one, by the names of their holes.
using PackageFacts = std::map<std::string, std::string>;
PackageFacts describe_package(const Robot& robot, const Scene& scene, const Generation& generation);

}  // namespace treeline
