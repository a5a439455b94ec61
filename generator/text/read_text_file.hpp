#pragma once

#include <optional>
#include <string>

#include "text/diagnostic.hpp"

namespace treeline {

/// All bytes of a file; `-` is standard input. Nothing, and an error that says why, when it is
/// missing, is a folder, cannot be read, has more than 64 MiB (no description of a robot does), is
/// compressed by gzip or is UTF-16 text.
std::optional<std::string> read_text_file(const std::string& path, Diagnostics& diagnostics);

/// Name of the file in messages: the path, or `standard input`.
std::string shown_path(const std::string& path);

/// False, with an error, where robot and scene are both to come from standard input.
bool can_read_both(const std::string& urdf, const std::string& scene, Diagnostics& diagnostics);

}  // namespace treeline
