#pragma once

#include <random>
#include <string>

namespace treeline::fuzz {

using Random = std::mt19937;

/// Separates URDF and scene in an input that contains both.
inline const std::string kSceneMark = "\n%scene\n";

/// Returns `text` with one part changed in a way that matters to a URDF reader: another number,
/// name, element or attribute of the grammar; subtrees that are copied, removed or nested;
/// entities; control characters.
std::string mutate_urdf(std::string text, Random& random);

/// Returns the text of a scene with one part changed in a way that matters to its reader: values,
/// keys and names of the grammar; lines that are copied, removed or indented; anchors, tags,
/// brackets.
std::string mutate_scene(std::string text, Random& random);

/// Changes either part of an input that contains both.
std::string mutate_both(const std::string& text, Random& random);

}  // namespace treeline::fuzz
