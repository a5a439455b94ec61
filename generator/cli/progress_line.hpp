#pragma once

#include <string>

namespace treeline {

/// Whether somebody sees what is written to stderr while it is.
bool is_watched();

/// Writes a line over the last one; an empty one clears it.
void show_progress(const std::string& line);

}  // namespace treeline
