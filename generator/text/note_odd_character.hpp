#pragma once

#include <string>
#include <string_view>

namespace treeline {

/// `: it has U+2212, a minus sign`, to be put behind a text that should be a number: the first
/// character that is not of ASCII may look like one that is. Empty if there is none.
std::string note_odd_character(std::string_view text);

/// Names the first or last character of a name if nobody sees it there. Empty if one sees both.
std::string name_outer_blank(std::string_view text);

}  // namespace treeline
