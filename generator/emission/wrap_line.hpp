#pragma once

#include <string>
#include <string_view>

namespace treeline {

/// `text` as lines of at most 100 columns, the first indented by `indentation` blanks, the others
/// by four more. Breaks behind an operator or comma, preferably one outside of parentheses.
std::string wrap_line(std::string_view text, std::size_t indentation);

/// A text for a hole of a template that has so much indentation: its first line without it, the
/// others indented beyond it. No end of line.
std::string wrap_in_hole(std::string_view text, std::size_t indentation);

}  // namespace treeline
