#pragma once

#include <filesystem>
#include <string>

#include "text/diagnostic.hpp"

namespace treeline {

/// Writes a file, of a temporary folder or one that was named, and the folders that it is in.
/// Errors: it cannot be written to its end.
bool write_work_file(const std::filesystem::path& path, const std::string& bytes,
                     Diagnostics& diagnostics);

}  // namespace treeline
