#pragma once

#include <filesystem>
#include <vector>

#include "description/diagnostic.hpp"
#include "emission/emit.hpp"

namespace treeline {

/// Makes `directory` hold `files`. They are written beside it first and renamed into place only
/// when all are complete, so that a failure leaves the old content; files that are equal already
/// are not touched. Files that the manifest there lists and that are no longer made are removed;
/// others are never. Errors are reported with the path and false is returned.
bool write_files(const std::filesystem::path& directory, const std::vector<GeneratedFile>& files,
                 Diagnostics& diagnostics);

}  // namespace treeline
