#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emission/compare_files.hpp"
#include "generation/generate_code.hpp"
#include "packaging/package_kinds.hpp"
#include "terminal/exit_code.hpp"
#include "text/diagnostic.hpp"
#include "timing/tune.hpp"

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

/// What `treeline generate` tells when it is done.
struct Summary {
  const std::vector<GeneratedFunction>& functions;
  const std::vector<FileDifference>& differences;  ///< before anything was written
  const std::string& output;
  std::size_t files = 0;  ///< that the folder has when all is up to date
  bool compared_only = false;
  bool verbose = false;            ///< with the algorithms that were not chosen
  const Tuning* tuning = nullptr;  ///< what was measured, if anything was
};

/// A table of functions with their costs, the choices made, and the files that differ.
std::string print_text(const Summary& summary);
std::string print_json(const Summary& summary);

/// A rule as makefiles have it, which says that `target` depends on these files; absolute paths.
/// Ninja and CMake (`DEPFILE`) read the same.
std::string print_depfile(const std::string& target, const std::vector<std::string>& files);

}  // namespace treeline
