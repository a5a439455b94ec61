#pragma once

#include <optional>
#include <string>

#include "description/diagnostic.hpp"

namespace treeline {

/// All bytes of a file. Nothing, and an error that says why, when it is missing, is a folder,
/// cannot be read or has more than 64 MiB (no description of a robot does).
std::optional<std::string> read_text_file(const std::string& path, Diagnostics& diagnostics);

}  // namespace treeline
