#pragma once

#include <span>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
#include "program/program.hpp"

namespace treeline::cpp {

/// The headers `runtime/core/link_*.hpp` with what `programs` need of them, which have functions
/// that loop over a table of links. They are in the namespace of the runtime.
std::vector<GeneratedFile> print_loop_headers(const EmissionContext& context,
                                              std::span<const Program> programs);

}  // namespace treeline::cpp
