#pragma once

#include <string>

#include "program/program.hpp"

namespace treeline {

/// Prints one line per node, in order: `%17 = %3 * %16  ; w4_x`. Sections are printed as comments,
/// results at the end.
std::string print_text(const Program& program);

/// Prints the program as a Graphviz digraph: values flow from left to right, results are boxes.
std::string print_dot(const Program& program);

}  // namespace treeline
