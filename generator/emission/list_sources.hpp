#pragma once

#include <span>
#include <vector>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline {

/// The functions that are emitted as sources: those asked for, and those of the controller.
std::vector<Program> list_sources(const EmissionContext& context,
                                  std::span<const Program> programs);

/// Whether one of them loops over a table of links; copies none.
bool has_loops(const EmissionContext& context, std::span<const Program> programs);

}  // namespace treeline
