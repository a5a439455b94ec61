#pragma once

#include <vector>

#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "packaging/describe_package.hpp"
#include "packaging/package_kind.hpp"

namespace treeline {

/// Files that cargo needs beside the code: a crate that compiles it and calls it by functions that
/// are safe, without the standard library.
std::vector<PackageFolder> for_rust(PackageFacts facts, const Robot& robot, const Scene& scene,
                                    const Generation& generation);

}  // namespace treeline
