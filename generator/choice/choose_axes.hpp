#pragma once

#include <cstddef>
#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"

namespace treeline {

/// Number of operations of `function` by its cheapest route as traced.
int count_cheapest(const Mechanism& mechanism, Function function);

/// Decides for each link in which axes recursions treat it and how they compute its angular
/// acceleration (`defers_rotation` and `carries_column`), by coordinate descent on the number of
/// operations of `frame_cost` as traced. Isomorphic limbs decide together, so that they can share
/// lanes.
void choose_axes(Mechanism& mechanism, Function frame_cost);

/// Counts the operations that the results need by the link for which they were traced (`section` in
/// recursion/tree/tree.hpp). Operations for no link come last, so there is one more number than
/// links.
std::vector<int> count_by_link(const Program& program, std::size_t links);

}  // namespace treeline
