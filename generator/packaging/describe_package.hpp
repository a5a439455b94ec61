#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

/// Facts about a package, by the names of the holes in its template.
using PackageFacts = std::map<std::string, std::string>;
PackageFacts describe_package(const Robot& robot, const Scene& scene, const Generation& generation);

/// A source in the package's folder `src`.
struct PackagedSource {
  std::string file;   ///< "gravity.c"
  std::string flags;  ///< that it alone is compiled with; empty: none
};

/// Lists the sources of a package in order of their names, each with its own flags, and behind them
/// the one that includes those that loop.
std::vector<PackagedSource> list_packaged_sources(const Scene& scene, const Generation& generation);

}  // namespace treeline
