#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace treeline {

/// A text from a file or a command line as it may stand on a terminal and in a source file: control
/// characters (line breaks too), marks that change the direction or the lines of a text, and bytes
/// that are not UTF-8 are written as `\x1b` or `\u202e`. Other characters stay.
std::string printable(std::string_view text);

/// Like `printable`, for text of several lines: line breaks and tabs stay.
std::string printable_lines(std::string_view text);

/// Like `printable`, for JSON, where such characters can stand in strings only. They become
/// `\u202e`, which a JSON reader turns back.
std::string printable_json(std::string_view json);

struct CodePoint {
  std::uint32_t value = 0;
  std::size_t length = 0;  ///< bytes taken; 0 when the text is not UTF-8 here
};

/// The first code point of a text that is not empty.
CodePoint decode_utf8(std::string_view text);

/// Whether the bytes are well-formed UTF-8 (no overlong forms, no surrogates).
bool is_utf8(std::string_view text);

/// `: it has U+2212, a minus sign`, to be put behind a text that should be a number: the first
/// character that is not of ASCII may look like one that is. Empty if there is none.
std::string note_odd_character(std::string_view text);

/// Names the first or last character of a name if nobody sees it there. Empty if one sees both.
std::string name_outer_blank(std::string_view text);

}  // namespace treeline
