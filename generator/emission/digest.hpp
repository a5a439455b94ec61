#pragma once

#include <string>
#include <string_view>

namespace treeline {

/// SHA-256 of the bytes (FIPS 180-4), 64 hexadecimal digits.
std::string digest(std::string_view bytes);

}  // namespace treeline
