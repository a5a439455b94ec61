#pragma once

#include <span>
#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline {

/// Lines of CMake that compile functions to small code, as `optimize` of the scene asks: all where
/// it is `size`; where it is `balanced` those whose code is modelled to be larger than the target's
/// first-level cache, so that loading it takes longer than running it. Empty where there are none.
std::string print_small_code(const EmissionContext& context, std::span<const Program> programs);

}  // namespace treeline
