#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace treeline::drive {

/// A word of a line, and where it begins.
struct Word {
  std::string_view text;
  std::size_t at = 0;
};

/// The words of a line, up to a comment.
std::vector<Word> split_line(std::string_view line);

/// "did you mean `elbow`?", or the names if none is near; of many, the first.
std::string suggest_word(std::string_view wanted, const std::vector<std::string>& names);

/// Shows a word of any bytes in an answer: what is not printable as `?`, what is long cut.
std::string shown_word(std::string_view word);

}  // namespace treeline::drive
