#pragma once

#include <string>
#include <vector>

#include "emission/generated_file.hpp"

namespace treeline {

/// Turns `#pragma once` at the beginning of files into include guards: coding rules for firmware
/// ask for them, and the pragma is no part of C or C++.
void guard_headers(const std::string& robot, std::vector<GeneratedFile>& files);

}  // namespace treeline
