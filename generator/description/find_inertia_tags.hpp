#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "description/scan_xml.hpp"

namespace treeline {

/// Finds for each link of a URDF, in the file's order, the tag `<inertia .../>` that counts: the
/// first in the first `<inertial>`. A link without one has no value. `text` must be a URDF that
/// `parse_urdf` accepts.
std::vector<std::optional<XmlTag>> find_inertia_tags(std::string_view text);

}  // namespace treeline
