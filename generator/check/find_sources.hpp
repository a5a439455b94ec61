#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "check/check.hpp"

namespace treeline {

/// Whether these flags let GCC fuse products and sums: the last one about it does not turn it off.
bool asks_contraction(const std::string& flags);

/// Returns the folder to compile: the given one, or a new one in `work` with the code generated
/// now. Errors: flags that change results, such as -ffast-math; the given folder is of another
/// scene.
std::optional<std::filesystem::path> find_sources(const Scene& scene, const Generation& generation,
                                                  const CheckOptions& options,
                                                  const std::filesystem::path& work,
                                                  Diagnostics& diagnostics);

}  // namespace treeline
