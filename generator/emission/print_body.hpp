#pragma once

#include <set>
#include <string>
#include <string_view>

#include "program/program.hpp"

namespace treeline {

/// The statements of the function, indented by two blanks, in the order of the program's nodes,
/// each result stored as soon as it is known. Sines and cosines that stand side by side are
/// computed by one call of `detail::sin_cos`. `taken` are identifiers that a local may not have;
/// `number` is the type of the locals.
std::string print_body(const Program& program, bool single_precision,
                       const std::set<std::string>& taken, std::string_view number = "Real");

}  // namespace treeline
