#pragma once

#include <string>
#include <vector>

namespace treeline {

/// Columns that the text takes: code points of UTF-8.
std::size_t width_of(const std::string& text);

/// The text in lines of at most so many columns: broken behind blanks, else behind what joins the
/// parts of a name (`_ - / .`), else anywhere. Lines after the first keep the indentation of the
/// first.
std::vector<std::string> wrap_cell(const std::string& text, std::size_t columns);

/// `label` and the text behind it, broken at blanks to so many columns in all; lines after the
/// first begin below the text.
std::string wrap_labelled(const std::string& label, const std::string& text, std::size_t columns);

}  // namespace treeline
