#pragma once

#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"

namespace treeline::c {

/// lanes.h: types of two, four and eight lanes, as many as the functions have at most.
std::vector<GeneratedFile> print_lane_types(const Contents& contents);

}  // namespace treeline::c
