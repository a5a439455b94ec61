#pragma once

#include <string>
#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"

namespace treeline {

/// The statements of a function that loops over a table of links: constants, work space, a call.
std::string print_loop_body(const EmissionContext& context, const Program& program);

/// NAME_links, the tables of links, and link_functions, the loops over them: the headers
/// `runtime/emitted/link_*.h` as one, with what the functions need.
std::vector<GeneratedFile> print_loops(const Contents& contents);

}  // namespace treeline
