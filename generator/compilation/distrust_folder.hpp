#pragma once

#include <filesystem>
#include <optional>

#include "text/diagnostic.hpp"

namespace treeline {

/// Why code is not to be loaded from a folder, as a warning with its remedy: somebody else than the
/// user who runs this program owns it or may write to it, or could put another in its place.
/// Nothing where it is only the user's, or is not there yet and would be.
std::optional<Diagnostic> reason_to_distrust(const std::filesystem::path& folder);

}  // namespace treeline
