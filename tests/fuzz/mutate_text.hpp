#pragma once

#include <random>
#include <string>

namespace treeline::fuzz {

using Random = std::mt19937;

/// What separates URDF and scene in an input that holds both.
inline const std::string kSceneMark = "\n%scene\n";

/// `text` with one part changed in a way that a reader of URDF takes notice of: another number,
/// name, element or attribute of the grammar, subtrees copied, removed or nested, entities, control
/// characters.
std::string mutate_urdf(std::string text, Random& random);

/// Likewise for a scene: values, keys and names of the grammar, lines copied, removed or indented,
/// anchors, tags, brackets.
std::string mutate_scene(std::string text, Random& random);

/// Either part of an input that holds both.
std::string mutate_both(const std::string& text, Random& random);

}  // namespace treeline::fuzz
