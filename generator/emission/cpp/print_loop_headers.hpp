#pragma once

#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"

namespace treeline::cpp {

/// NAME_links.hpp, and the headers `runtime/core/link_*.hpp` with only what the functions need.
std::vector<GeneratedFile> print_loops(const Contents& contents);

}  // namespace treeline::cpp
