#pragma once

#include <string>
#include <vector>

#include "emission/list_sources.hpp"

namespace treeline {

/// CMakeLists.txt, which builds the folder as part of another project. GCC makes extra passes where
/// it optimises, but for long functions.
std::string print_project(const EmissionContext& context, const std::vector<Source>& sources);

}  // namespace treeline
