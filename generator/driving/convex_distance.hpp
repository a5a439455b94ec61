#pragma once

#include "drawing/read_visuals.hpp"

namespace treeline {

/// Distance between two boxes, cylinders or spheres with poses in the world, m; 0 if they overlap.
/// The algorithm of Gilbert, Johnson and Keerthi (1988).
double convex_distance(const Visual& a, const Visual& b);

/// z of the lowest point of a box, cylinder or sphere in the world, m.
double lowest_of(const Visual& shape);

}  // namespace treeline
