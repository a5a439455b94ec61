#include "description/bound_xml.hpp"

#include <fmt/format.h>

#include "description/scan_xml.hpp"

namespace treeline {

std::optional<XmlExcess> find_excess(std::string_view text) {
  std::size_t tags = 0, attributes = 0;
  for (std::size_t at = 0, before = 0; const auto tag = next_tag(text, at); before = at) {
    attributes += tag->attribute_count;
    if (++tags > kMostTags) {
      return XmlExcess{fmt::format("the file has more than {} tags", kMostTags), before};
    }
    if (tag->attribute_count > kMostAttributesOfElement) {
      return XmlExcess{fmt::format("an element has {} attributes, more than {}",
                                   tag->attribute_count, kMostAttributesOfElement),
                       before};
    }
    if (attributes > kMostAttributes) {
      return XmlExcess{fmt::format("the file has more than {} attributes", kMostAttributes),
                       before};
    }
  }
  return std::nullopt;
}

}  // namespace treeline
