#pragma once

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

}  // namespace treeline
