#pragma once

#include <sdf/Link.hh>
#include <vector>

#include "description/flat/flat_model.hpp"

namespace treeline {

/// Shapes of a link's `<visual>` and `<collision>` that URDF has, too: boxes, cylinders, spheres
/// and meshes, with diffuse colours. `model://` becomes `package://`. Others are left out: they are
/// for pictures alone.
std::vector<FlatShape> read_shapes(const sdf::Link& link);

}  // namespace treeline
