#pragma once

#include <string>
#include <vector>

namespace treeline {

/// Replacement of some bytes of a text.
struct TextEdit {
  std::size_t at = 0, size = 0;
  std::string text;
};

/// Applies the edits to the text. Every other byte stays.
std::string apply_edits(const std::string& text, const std::vector<TextEdit>& edits);

/// Prints the edits as a unified diff with three lines of context, for `patch` and `git apply`.
/// Empty if there are no edits.
std::string print_patch(const std::string& file, const std::string& text,
                        const std::vector<TextEdit>& edits);

}  // namespace treeline
