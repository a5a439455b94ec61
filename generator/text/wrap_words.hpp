#pragma once

#include <string>
#include <vector>

namespace treeline {

/// Width of the text in code points of UTF-8.
std::size_t width_of(const std::string& text);

/// Breaks the text into lines of at most `columns` columns: after spaces, else after the characters
/// that join the parts of a name (`_ - / .`), else anywhere. All lines have the indentation of the
/// first.
std::vector<std::string> wrap_cell(const std::string& text, std::size_t columns);

/// Prints `label` followed by the text, broken at spaces to `columns` columns in total. Lines after
/// the first begin below the text.
std::string wrap_labelled(const std::string& label, const std::string& text, std::size_t columns);

}  // namespace treeline
