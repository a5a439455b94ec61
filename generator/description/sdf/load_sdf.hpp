#pragma once

#include <optional>
#include <sdf/Root.hh>

#include "description/sdf/sdf_module.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// libsdformat's reading of a text, with the places of `read_sdf`. Its errors
/// become errors in `diagnostics`, but what it says of inertias does not: that is for the readers
/// of URDF. Elements that SDF does not know are warnings.
std::optional<sdf::Root> load_sdf(const SdfText& text, Diagnostics& diagnostics);

}  // namespace treeline
