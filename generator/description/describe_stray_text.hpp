#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace treeline {

/// Content of a file that is not the XML asked for, and what to do about it.
struct StrayText {
  std::string fault, remedy;
};

/// Recognises what stands in the place of a file that did not arrive: a pointer of Git LFS, a
/// web page, or the path that a symbolic link leads to, where the link was copied as text. Else
/// nothing.
std::optional<StrayText> describe_stray_text(std::string_view text);

}  // namespace treeline
