#pragma once

#include <vector>

#include "packaging/package_kind.hpp"

namespace treeline {

/// The package that holds generated code: the code as it is in `src`, and beside it what the tool
/// wants to know. Where `kind` is null the code itself, without a folder `src`.
std::vector<PackageFolder> make_package(const PackageKind* kind, const Robot& robot,
                                        const Scene& scene, const Generation& generation);

}  // namespace treeline
