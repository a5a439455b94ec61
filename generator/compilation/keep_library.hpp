#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compilation/run_commands.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// The folder of libraries that earlier runs compiled: the environment variable TREELINE_CACHE,
/// else `treeline` in XDG_CACHE_HOME, else `.cache/treeline` in HOME. Empty, so that nothing is
/// kept: TREELINE_CACHE is set and empty, or is not set and neither other is an absolute path.
std::filesystem::path folder_of_kept_libraries();

/// Returns a name for what `commands` and then `linking` make of the sources and headers below
/// `work`: another one where a byte of these, a flag, the compiler, its version, its target or the
/// processor that it compiles for differs. The place of `work` does not matter. Runs the compiler,
/// whose output goes to `work`.
std::string identify_library(const Command& compiler, std::vector<Command> commands,
                             const Command& linking, const std::filesystem::path& work);

/// Copies the library of that name to `destination`. Returns false where the folder holds none, or
/// one whose bytes are not those that were kept.
bool take_kept_library(const std::filesystem::path& folder, const std::string& name,
                       const std::filesystem::path& destination);

/// Keeps a copy of the library for `take_kept_library`, and removes all but the 32 that were used
/// last. Does nothing where the folder cannot be made or written: the library is there anyway.
void keep_library(const std::filesystem::path& library, const std::filesystem::path& folder,
                  const std::string& name);

/// Why code is not to be loaded from a folder, as a warning with its remedy: somebody else than the
/// user who runs this program owns it or may write to it, or could put another in its place.
/// Nothing where it is only the user's, or is not there yet and would be.
std::optional<Diagnostic> reason_to_distrust(const std::filesystem::path& folder);

}  // namespace treeline
