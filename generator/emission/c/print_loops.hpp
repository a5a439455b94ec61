#pragma once

#include <string>
#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"

namespace treeline::c {

/// The statements of a function that loops over a table of links: constants, work space, a call.
std::string print_loop_body(const EmissionContext& context, const Program& program);

/// NAME_links.h, the tables of links, and the headers that loop over them: those of C++
/// (runtime/core/link_*.hpp) in C.
std::vector<GeneratedFile> print_loops(const Contents& contents);

}  // namespace treeline::c
