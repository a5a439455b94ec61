#pragma once

#include <set>
#include <string>

#include "emission/syntax.hpp"
#include "program/program.hpp"

namespace treeline {

/// The statements of the function, indented by two blanks, in the order of the program's nodes,
/// each result stored as soon as it is known. Sines and cosines that stand side by side are
/// computed by one call of what `syntax` calls for them. `taken` are identifiers that a local may
/// not have.
std::string print_body(const Program& program, const Syntax& syntax,
                       const std::set<std::string>& taken);

}  // namespace treeline
