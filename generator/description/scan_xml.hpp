#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace treeline {

/// An attribute in XML text; both views lie in the text that was scanned.
struct XmlAttribute {
  std::string_view name;
  std::string_view value;  ///< between the quotes, entities as written
};

/// What stands between `<` and `>`.
struct XmlTag {
  enum class Kind { start, end, empty, other };  ///< other: comment, CDATA, declaration, DOCTYPE
  Kind kind = Kind::other;
  std::string_view name;  ///< of start, end and empty
  std::vector<XmlAttribute> attributes;
  std::size_t attribute_count = 0;  ///< all of them; `attributes` has the first `kKeptAttributes`
  bool has_slash = false;           ///< one behind the name: `<link/>`, but also `</link/>`
};
inline constexpr std::size_t kKeptAttributes = 64;

/// The next tag at or after `at`, which moves behind it; nothing when there is none. Finds the
/// places of what a reader of XML has understood: text that is not well-formed gives tags of some
/// kind, in time linear in its length.
std::optional<XmlTag> next_tag(std::string_view text, std::size_t& at);

/// Finds for each link of a URDF, in the file's order, the tag `<inertia .../>` that counts: the
/// first in the first `<inertial>`. A link without one has no value. `text` must be a URDF that
/// `parse_urdf` accepts.
std::vector<std::optional<XmlTag>> find_inertia_tags(std::string_view text);

}  // namespace treeline
