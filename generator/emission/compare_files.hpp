#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "emission/emit.hpp"

namespace treeline {

enum class Difference { missing, changed, left_over };

struct FileDifference {
  std::string name;
  Difference difference = Difference::changed;
};

/// How `directory` differs from what would be written: files that are missing or have other bytes,
/// and left-overs of an earlier generation that its manifest lists. In order of name; empty when
/// the directory is up to date.
std::vector<FileDifference> compare_files(const std::filesystem::path& directory,
                                          const std::vector<GeneratedFile>& files);

}  // namespace treeline
