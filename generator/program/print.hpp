#pragma once

#include <string>

#include "program/program.hpp"

namespace treeline {

/// One line a node, in order: `%17 = %3 * %16  ; w4_x`, sections as comments, results at the end.
std::string print_text(const Program& program);

/// The same as a Graphviz digraph: values flow from left to right, results are boxes.
std::string print_dot(const Program& program);

}  // namespace treeline
