#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "generation/generate_code.hpp"

namespace treeline {

/// Prints a source file in C++ with the entries of `print_entry` for a folder in OpenCL C. Each
/// runs a kernel for several states, of which it is given one. The driver of a device compiles the
/// folder, when `treeline_check_fault` is called: it returns what went wrong, else null.
std::string print_opencl_entry(const std::filesystem::path& folder, const std::string& name,
                               const std::vector<GeneratedFunction>& functions);

}  // namespace treeline
