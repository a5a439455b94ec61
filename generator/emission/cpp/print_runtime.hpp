#pragma once

#include <span>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
#include "program/program.hpp"

namespace treeline::cpp {

/// The headers of the runtime that the sources include.
std::vector<GeneratedFile> print_runtime(const EmissionContext& context,
                                         std::span<const Program> programs,
                                         std::span<const Program> batch);

}  // namespace treeline::cpp
