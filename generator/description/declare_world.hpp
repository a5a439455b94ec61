#pragma once

#include <tinyxml2.h>

#include "description/urdf_element.hpp"

namespace treeline {

/// Adds the link `world` where a joint has it for its parent and no link has this name, as files do
/// for programs that know a world: it is what holds the base. With a note.
void declare_world(tinyxml2::XMLElement& robot, UrdfReading& reading);

}  // namespace treeline
