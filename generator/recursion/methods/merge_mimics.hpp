#pragma once

#include "recursion/parameters/base_parameters.hpp"

namespace treeline {

/// Merges those base parameters that depend on each other because joints mimic others. Does nothing
/// for robots without mimic joints. See `find_base_parameters`.
void merge_mimics(const Mechanism& mechanism, const Digits50& tolerance, BaseParameters& found);

}  // namespace treeline
