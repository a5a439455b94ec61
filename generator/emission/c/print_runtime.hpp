#pragma once

#include <span>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
#include "program/program.hpp"

namespace treeline::c {

/// The headers that the sources include: sine and cosine, lanes, loops of damped control.
std::vector<GeneratedFile> print_runtime(const EmissionContext& context,
                                         std::span<const Program> programs,
                                         std::span<const Program> batch);

}  // namespace treeline::c
