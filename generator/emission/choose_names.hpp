#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// A legal name for a local variable: other characters than letters and digits become single
/// underscores; what C++ or its headers have already gets a suffix. Never empty.
std::string make_identifier(std::string_view text);

/// Finds a unique name for each constant in `Program::constants`; these become `taken`.
std::map<std::uint32_t, std::string> name_constants(const Program& program,
                                                    std::set<std::string>& taken);

/// Finds for every `wanted` node the identifier of its value, unique and none of `reserved`; empty
/// for the others. A value is named by what it is: as the trace named it (`f4_x`), as sine or
/// cosine of a sum of angles (`s23`), or after its place in a result (`M_0_3`). Other values have
/// neutral names, `t17`. A pack of lanes has one name, at its first node: `f8_15_x`.
std::vector<std::string> choose_names(const Program& program, std::vector<bool> wanted,
                                      std::set<std::string> reserved);

}  // namespace treeline
