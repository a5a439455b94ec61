#pragma once

#include <map>
#include <string>

namespace treeline {

/// The lines of the aliases (`*name`) in a YAML document that is well formed, by their places, such
/// as `operational_points[0]/link`. The library gives what an alias stands for the line of its
/// anchor, wherever it is used.
std::map<std::string, int> alias_lines(const std::string& text);

}  // namespace treeline
