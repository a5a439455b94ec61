#pragma once

#include <chrono>
#include <filesystem>
#include <vector>

#include "emission/emit.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Makes `directory` hold `files`. They are written to a folder inside it first and renamed into
/// place only when all are complete, so that a failure or a signal leaves the old content; files
/// that are equal already are not touched. Files that the manifest there lists and that are no
/// longer made are removed; others are never. Of several runs that write to one folder each waits
/// for the others, at most `patience`. Errors are reported with the path and false is returned.
bool write_files(const std::filesystem::path& directory, const std::vector<GeneratedFile>& files,
                 Diagnostics& diagnostics,
                 std::chrono::milliseconds patience = std::chrono::seconds(20));

}  // namespace treeline
