#pragma once

#include <span>
#include <string>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
#include "program/program.hpp"

namespace treeline::c {

/// The statements of a function that loops over a table of links: constants, work space, a call.
std::string print_loop_body(const EmissionContext& context, const Program& program);

/// NAME_links.h, the tables of links; empty where no function loops over them.
std::vector<GeneratedFile> print_loops(const EmissionContext& context,
                                       std::span<const Program> programs);

/// The headers that loop over the tables: those of C++ (runtime/core/link_*.hpp) in C.
std::vector<GeneratedFile> print_loop_headers(const EmissionContext& context,
                                              std::span<const Program> programs);

/// The stem of a source that CMake makes of those of the functions that loop, so that they share
/// the loops, which are static functions in C; empty where there are fewer than two.
std::string joined_loops(const EmissionContext& context, std::span<const Program> programs);

}  // namespace treeline::c
