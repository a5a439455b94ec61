#pragma once

#include <cstddef>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Operations that the results need, by the link that they were traced for (`section` in
/// recursion/tree.hpp); what was traced for none comes last, so that there is one number more than
/// links.
std::vector<int> count_by_link(const Program& program, std::size_t links);

}  // namespace treeline
