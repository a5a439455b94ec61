#pragma once

#include <cstddef>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Counts the operations that the results need by the link for which they were traced (`section` in
/// recursion/tree/tree.hpp). Operations for no link come last, so there is one more number than
/// links.
std::vector<int> count_by_link(const Program& program, std::size_t links);

}  // namespace treeline
