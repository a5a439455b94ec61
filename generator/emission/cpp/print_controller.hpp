#pragma once

#include <string>
#include <vector>

#include "emission/controller_unit.hpp"
#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"

namespace treeline::cpp {

/// `NAME_controller.h`, for C99 and C++17; `controller.cpp`, which defines the step; and a source
/// for each function that it calls.
std::vector<GeneratedFile> print_controller(const EmissionContext& context,
                                            const ControllerUnit& unit);

/// Headers of runtime/core that `controller.cpp` includes.
std::vector<GeneratedFile> list_controller_headers();

}  // namespace treeline::cpp
