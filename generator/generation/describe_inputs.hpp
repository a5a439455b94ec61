#pragma once

#include <string>
#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Appends what the entries of `payload`, `parameters`, `tool`, `tool_orientation`, `contact` and
/// `active` belong to, and what the files say of them.
void append_input_notes(const Scene& scene, const Mechanism& mechanism,
                        std::vector<std::string>& notes);

}  // namespace treeline
