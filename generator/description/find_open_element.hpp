#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace treeline {

/// An element whose start tag has been read and whose end tag has not.
struct OpenElement {
  std::string name;
  std::string tag;  ///< `<link name="arm">`, or `<link>` without a name
  int line = 0;     ///< of the start tag, from 1 on
};

/// Element without its end tag in text that is no XML, and what stands in place of the end tag.
struct UnclosedElement {
  OpenElement open;
  std::string instead;  ///< the end tag that comes in place of its own; empty: the text ends
  int line = 0;         ///< of that
};

/// The first element that is not closed by its own end tag. Comments, CDATA, declarations and
/// quoted attributes are passed over. Nothing where tags fit, or where another fault comes first.
std::optional<UnclosedElement> find_unclosed_element(std::string_view text);

/// The innermost element that is open where that line begins; nothing outside the root.
std::optional<OpenElement> find_open_element(std::string_view text, int line);

}  // namespace treeline
