#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace treeline {

/// What a URDF may hold at most; `read_text_file` bounds its bytes, `read_urdf` its links. Within
/// these the document of a file of 64 MiB takes less than 1 GiB and seconds.
inline constexpr std::size_t kMostTags = 400'000;  ///< with end tags and comments
inline constexpr std::size_t kMostAttributes = 1'000'000;
inline constexpr std::size_t kMostAttributesOfElement = 64;  ///< they are compared with each other

/// What is too much, in words, and the byte at which it becomes so.
struct XmlExcess {
  std::string fault;
  std::size_t at = 0;
};

/// Looks for more than the bounds, before a document is built of the text.
std::optional<XmlExcess> find_excess(std::string_view text);

}  // namespace treeline
