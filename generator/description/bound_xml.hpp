#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace treeline {

/// Limits on a URDF's content; `read_text_file` limits its bytes, `read_urdf` its links. Within
/// these the document of a file of 64 MiB takes less than 1 GiB and seconds.
inline constexpr std::size_t kMostTags = 400'000;  ///< with end tags and comments
inline constexpr std::size_t kMostAttributes = 1'000'000;
inline constexpr std::size_t kMostAttributesOfElement = 64;  ///< they are compared with each other

/// Excess of a URDF, in words, and the byte at which it begins.
struct XmlExcess {
  std::string fault;
  std::size_t at = 0;
};

/// Looks for more than the bounds, before a document is built of the text.
std::optional<XmlExcess> find_excess(std::string_view text);

}  // namespace treeline
