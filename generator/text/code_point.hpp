#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace treeline {

struct CodePoint {
  std::uint32_t value = 0;
  std::size_t length = 0;  ///< bytes taken; 0 when the text is not UTF-8 here
};

/// The first code point of a text that is not empty.
CodePoint decode_utf8(std::string_view text);

/// Whether the bytes are well-formed UTF-8 (no overlong forms, no surrogates).
bool is_utf8(std::string_view text);

}  // namespace treeline
