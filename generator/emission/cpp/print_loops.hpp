#pragma once

#include <span>
#include <string>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
#include "program/program.hpp"

namespace treeline::cpp {

/// The statements of a function that loops over a table of links: constants, work space, a call.
std::string print_loop_body(const EmissionContext& context, const Program& program);

/// NAME_links.hpp: the tables of links.
GeneratedFile print_link_tables(const EmissionContext& context, std::span<const Program> programs);

}  // namespace treeline::cpp
