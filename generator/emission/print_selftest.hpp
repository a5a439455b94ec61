#pragma once

#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"

namespace treeline {

/// Stem of the source.
inline constexpr const char* kSelftestStem = "selftest";

/// NAME_selftest.h and the source that calls the functions, of the context's numbers for it.
std::vector<GeneratedFile> print_selftest(const Contents& contents);

}  // namespace treeline
