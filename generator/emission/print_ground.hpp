#pragma once

#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"
#include "emission/ground_unit.hpp"

namespace treeline {

/// Stem of the source that defines the step on the ground.
inline constexpr const char* kGroundStem = "ground";

/// The most points of a robot that count at once: four of each group, sixteen of all.
int count_ground_contacts(const GroundUnit& unit);

/// `NAME_ground.h`, for C99 and C++17; the source `ground`, which defines the step, with its
/// headers; and a source for each function that it calls.
std::vector<GeneratedFile> print_ground(const Contents& contents);

}  // namespace treeline
