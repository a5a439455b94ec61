#pragma once

#include <string>
#include <vector>

namespace treeline {

/// A rule as makefiles have it, which says that `target` depends on these files; absolute paths.
/// Ninja and CMake (`DEPFILE`) read the same.
std::string print_depfile(const std::string& target, const std::vector<std::string>& files);

}  // namespace treeline
