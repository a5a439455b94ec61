#pragma once

#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "packaging/describe_package.hpp"
#include "packaging/package_kind.hpp"

namespace treeline {

/// Files that npm and browsers need beside the code: a script that compiles it to WebAssembly, a
/// module that calls it, and types.
std::vector<PackageFolder> for_wasm(PackageFacts facts, const Robot& robot, const Scene& scene,
                                    const Generation& generation);

}  // namespace treeline
