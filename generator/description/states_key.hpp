#pragma once

#include <string>

namespace treeline {

/// Whether the text of a scene has a key, such as `functions`; false for one that cannot be parsed.
bool states_key(const std::string& scene_text, const std::string& key);

}  // namespace treeline
