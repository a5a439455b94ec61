#pragma once

#include <map>
#include <string>
#include <string_view>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

/// Facts about a package, by the names of the holes in its template.
using PackageFacts = std::map<std::string, std::string>;
PackageFacts describe_package(const Robot& robot, const Scene& scene, const Generation& generation);

/// A template filled with those facts that it names.
std::string fill_facts(std::string_view text, const PackageFacts& facts);

}  // namespace treeline
