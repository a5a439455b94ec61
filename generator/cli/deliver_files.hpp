#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emission/compare_files.hpp"
#include "packaging/make_package.hpp"
#include "terminal/exit_code.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// How a folder and those inside it differ from what would be written, see `compare_files`. Names
/// begin with the folder inside: `src/gravity.cpp`.
std::vector<FileDifference> compare_folders(const std::string& output,
                                            const std::vector<PackageFolder>& folders);

/// Writes each folder, see `write_files`. False if one could not be written.
bool write_folders(const std::string& output, const std::vector<PackageFolder>& folders,
                   Diagnostics& diagnostics);

/// Number of files in all folders.
std::size_t count_files(const std::vector<PackageFolder>& folders);

}  // namespace treeline
