#pragma once

#include <vector>

#include "program/expression.hpp"

namespace treeline {

/// Finds for each node of a graph the section in which it was built; null before the first. Valid
/// as long as the graph's sections.
std::vector<const Graph::Section*> find_sections(const Graph& graph);

}  // namespace treeline
