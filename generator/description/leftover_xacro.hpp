#pragma once

#include <tinyxml2.h>

#include <string>

#include "text/diagnostic.hpp"

namespace treeline {

/// Remains of xacro in a URDF, which other readers ignore.
struct LeftoverXacro {
  int line = 0;         ///< of the first; 0: there is none
  std::string element;  ///< the first
  std::string fault;    ///< what was passed over, with counts
  std::string remedy;   ///< how to expand the file
};

/// Finds elements `<xacro:...>` and `${...}`, `$(...)` in the element `<robot>`. Where they stand
/// in what makes the mechanism (in a number, a type, a name that the file does not define; an
/// element of xacro inside a link or a joint, or one that holds or would add links or joints) there
/// is an error in `diagnostics`; all else can be passed over, and is listed.
LeftoverXacro find_leftover_xacro(const tinyxml2::XMLElement& robot, const std::string& file,
                                  Diagnostics& diagnostics);

}  // namespace treeline
