#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace treeline {

/// A file of the generated folder; `name` is relative to it and has no directory.
struct GeneratedFile {
  std::string name;
  std::string text;
};

/// SHA-256 of the bytes (FIPS 180-4), 64 hexadecimal digits.
std::string digest(std::string_view bytes);

/// Puts the line by which tools find the licence of a file at its head, after the line that names
/// its interpreter. Files in which no comment can stand stay as they are.
void state_licence(GeneratedFile& file);

/// Turns `#pragma once` at the beginning of files into include guards: coding rules for firmware
/// ask for them, and the pragma is no part of C or C++.
void guard_headers(const std::string& robot, std::vector<GeneratedFile>& files);

/// `0.1.0`: the version of the project that this program was built from, the same for every build
/// of it.
const char* generator_version();

}  // namespace treeline
