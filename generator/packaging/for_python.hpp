#pragma once

#include <string>
#include <vector>

#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "packaging/describe_package.hpp"
#include "packaging/package_kind.hpp"

namespace treeline {

/// Files that pip needs beside the code: a package that compiles it as an extension of Python.
std::vector<PackageFolder> for_python(PackageFacts facts, const Robot& robot, const Scene& scene,
                                      const Generation& generation);

}  // namespace treeline
