#pragma once

#include <string>
#include <vector>

#include "drawing/camera.hpp"
#include "drawing/solids.hpp"

namespace treeline {

/// A line through points of a picture, as the data of an SVG path: the first point, then the steps
/// from one to the next.
std::string print_line(const std::vector<Eigen::Vector2i>& points);

/// What is to be seen of solids, as elements of SVG in the camera's units, painted in
/// `currentColor` of each. What is nearer is painted over what is behind it: by the middles of
/// faces. Faces of four corners are cut before until no edge is longer than `longest`, m.
std::string print_solids(const Camera& camera, const Solids& solids, double longest);

}  // namespace treeline
