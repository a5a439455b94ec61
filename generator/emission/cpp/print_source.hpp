#pragma once

#include <set>
#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline::cpp {

/// `void NAME(const Real (&q)[6], Real (&tau)[6]) noexcept;`, as the header declares it.
std::string print_declaration(const Program& program);

/// The source file that defines the program's function.
std::string print_source(const EmissionContext& context, const Program& program);

/// Names that no local may have.
std::set<std::string> find_taken(const EmissionContext& context, const Program& program);

}  // namespace treeline::cpp
