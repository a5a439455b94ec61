#pragma once

#include "emission/generated_file.hpp"

namespace treeline {

/// Puts the line by which tools find the licence of a file at its head, after the line that names
/// its interpreter. Files in which no comment can stand stay as they are.
void state_licence(GeneratedFile& file);

}  // namespace treeline
