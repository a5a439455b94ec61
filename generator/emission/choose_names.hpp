#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// A legal name for a local variable: other characters than letters and digits become single
/// underscores; what C++ or its headers have already gets a suffix. Never empty.
std::string make_identifier(std::string_view text);

/// For every node that is `wanted` the identifier of its value, unique and none of `reserved`;
/// empty for the others. A node that the trace named keeps its name, a result is called after its
/// place
/// (`M_0_3`), any other after the named value or result that it is a part of (`f4_x_p1`).
std::vector<std::string> choose_names(const Program& program, const std::vector<bool>& wanted,
                                      std::set<std::string> reserved);

}  // namespace treeline
