#pragma once

#include <string>
#include <string_view>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline::c {

/// `void NAME_gravity(const double q[TREELINE_NAME_ARRAY(6)], ...)`: alike in header and source.
std::string print_signature(const EmissionContext& context, const Program& program);

/// Statements that read what the function does not: C has no parameters without names. `suffix` is
/// what stands behind the names of arguments.
std::string print_unread(const Program& program, std::string_view suffix = {});

/// A parameter that is an array of so many elements.
std::string print_array(const EmissionContext& context, const char* qualifier,
                        const std::string& name, int size);

/// The declaration of the program's function, without its contract.
std::string print_declaration(const EmissionContext& context, const Program& program);

/// The source file that defines the program's function.
std::string print_source(const EmissionContext& context, const Program& program);

}  // namespace treeline::c
