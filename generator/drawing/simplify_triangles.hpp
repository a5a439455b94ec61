#pragma once

#include <cstddef>
#include <vector>

#include "description/mesh/mesh.hpp"

namespace treeline {

/// Reduces triangles to at most `most`, or to where no edge can vanish without turning a triangle
/// over: edges collapse in the order of the error that this makes, the sum of squared distances to
/// the planes of the triangles they stand for, weighted by area (Garland and Heckbert 1997). What
/// was one surface stays one, and parts of several meshes compete for the triangles. The order of
/// what stays is that of the input. `tags` name what a triangle belongs to and are reduced alike:
/// no edge collapses between two tags.
void simplify_triangles(std::vector<Triangle>& triangles, std::vector<std::size_t>& tags,
                        std::size_t most);

}  // namespace treeline
