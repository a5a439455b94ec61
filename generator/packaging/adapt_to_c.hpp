#pragma once

#include <string>

#include "description/scene.hpp"
#include "packaging/package_kind.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Adapts a scene to such a package: C, and no controller beside functions in an FMU. Says so where
/// the scene, of which `text` is what was read, asks for something else.
void adapt_to_c(const PackageKind& kind, const std::string& text, Scene& scene,
                Diagnostics& diagnostics);

}  // namespace treeline
