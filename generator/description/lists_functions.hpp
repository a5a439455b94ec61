#pragma once

#include <string>

namespace treeline {

/// Whether the text of a scene asks for functions by name; false for one that cannot be parsed.
bool lists_functions(const std::string& scene_text);

}  // namespace treeline
