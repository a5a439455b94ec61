#pragma once

#include <vector>

#include "emission/contents.hpp"
#include "emission/controller_unit.hpp"
#include "emission/generated_file.hpp"

namespace treeline {

/// Stem of the source of a controller's step.
inline constexpr const char* kControllerStem = "controller";

/// `NAME_controller.h`, for C99 and C++17; the source `controller`, which defines the step, with
/// its headers; and a source for each function that it calls.
std::vector<GeneratedFile> print_controller(const Contents& contents);

/// The step in C++, in numbers of a type `Real` that another header has, for references.
std::vector<GeneratedFile> print_reference_laws(const EmissionContext& context,
                                                const ControllerUnit& unit);

}  // namespace treeline
