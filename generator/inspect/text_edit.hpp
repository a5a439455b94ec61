#pragma once

#include <string>
#include <vector>

namespace treeline {

/// Bytes of a text that something else takes the place of.
struct TextEdit {
  std::size_t at = 0, size = 0;
  std::string text;
};

/// The text with edits made; every other byte stays.
std::string apply_edits(const std::string& text, const std::vector<TextEdit>& edits);

/// The edits as a unified diff with three lines of context, for `patch` and `git apply`; empty
/// where there is none.
std::string print_patch(const std::string& file, const std::string& text,
                        const std::vector<TextEdit>& edits);

}  // namespace treeline
