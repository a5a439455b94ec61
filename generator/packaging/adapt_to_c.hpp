#pragma once

#include <string>
#include <string_view>

#include "description/scene.hpp"
#include "packaging/package_kind.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Whether it is a Functional Mock-up Unit, of any version.
bool is_fmu(PackageKind kind);

/// Whether such a package is compiled from C, whatever the scene says.
bool is_compiled_from_c(PackageKind kind);

/// Names a package that is compiled from C: "a package for Python", "an FMU"; empty for others.
std::string describe(PackageKind kind);

/// The word of `--package` for a package that is compiled from C; empty for others.
std::string option_of(PackageKind kind);

/// The language whose programs call the C in a package of this kind; empty where C or C++ does.
std::string_view caller_of(PackageKind kind);

/// Adapts a scene to such a package: C, and no controller beside functions in an FMU. Says so where
/// the scene, of which `text` is what was read, asks for something else.
void adapt_to_c(PackageKind kind, const std::string& text, Scene& scene, Diagnostics& diagnostics);

}  // namespace treeline
