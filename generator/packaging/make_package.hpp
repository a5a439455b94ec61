#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "emission/generated_file.hpp"
#include "generation/generate_code.hpp"
#include "packaging/package_kind.hpp"

namespace treeline {

/// A folder of a package and the files that lie in it.
struct PackageFolder {
  std::string path;  ///< in the package; empty: the package itself
  std::vector<GeneratedFile> files;
};

/// The package that holds generated code: the code as it is in `src`, and beside it what the tool
/// wants to know. For `none` the code itself, without a folder `src`.
std::vector<PackageFolder> make_package(PackageKind kind, const Robot& robot, const Scene& scene,
                                        const Generation& generation);

}  // namespace treeline
