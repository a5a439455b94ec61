#pragma once

#include <tinyxml2.h>

#include <optional>
#include <string>
#include <string_view>

namespace treeline {

/// A tag that the reader of XML understands otherwise than it is written.
struct MisreadTag {
  int line = 0;  ///< from 1 on
  std::string fault, remedy;
};

/// The first tag of `text` that tinyxml2 let pass though it is no XML, or read as another element
/// than it says. It ends its reading, without a word, at an end tag that closes nothing; it takes
/// `</link name="a"/>` as an empty element, and `</link name="a">` as `</link>`. Where nothing is
/// returned, the elements of `document` are those that `next_tag` finds, in the same order.
std::optional<MisreadTag> find_misread_tag(const tinyxml2::XMLDocument& document,
                                           std::string_view text);

}  // namespace treeline
