#pragma once

#include <tinyxml2.h>

#include <optional>
#include <string>

#include "text/diagnostic.hpp"

namespace treeline {

/// Fills `document` with the XML in `bytes` and returns its root element, `<robot>`. Nothing, and
/// an error, when the text is not well-formed, is no UTF-8, has no or several roots, gives an
/// attribute twice, or is another format (old SDF): each with the line and the remedy.
const tinyxml2::XMLElement* parse_urdf_xml(const std::string& bytes, const std::string& file,
                                           tinyxml2::XMLDocument& document,
                                           Diagnostics& diagnostics);

/// Checks XML with any root, for another reader, and returns text that a strict reader accepts.
std::optional<std::string> well_formed_xml(const std::string& bytes, const std::string& file,
                                           Diagnostics& diagnostics);

}  // namespace treeline
