#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace treeline {

/// Lists at most `most` names and counts the others: "a, b and 3 more".
std::string list_first(const std::vector<std::string>& names, std::size_t most);

}  // namespace treeline
