#include <fmt/format.h>

#include <algorithm>

#include "description/scan_xml.hpp"
#include "description/xml_faults.hpp"

namespace treeline {
namespace {

/// The element that comes behind `node` in the text; null behind the last.
const tinyxml2::XMLElement* next_element(const tinyxml2::XMLNode& node) {
  if (const auto* child = node.FirstChildElement()) return child;
  for (const auto* at = &node; at != nullptr; at = at->Parent()) {
    if (const auto* sibling = at->NextSiblingElement()) return sibling;
  }
  return nullptr;
}

/// Fault of an end tag in itself.
std::optional<MisreadTag> judge_end(const XmlTag& tag, int line) {
  const char* const remedy = "remove the slash before its name, or what stands behind the name";
  if (tag.has_slash) {
    return MisreadTag{line, fmt::format("</{}/> has two slashes", tag.name), remedy};
  }
  if (tag.attribute_count > 0) {
    return MisreadTag{line, fmt::format("the end tag </{}> has attributes", tag.name), remedy};
  }
  return std::nullopt;
}

/// Walks the tags of a text beside the elements that were read.
class TagComparison {
 public:
  explicit TagComparison(const tinyxml2::XMLNode& document) : element_(&document) {}

  std::optional<MisreadTag> take(const XmlTag& tag, int line) {
    if (tag.kind == XmlTag::Kind::end) return take_end(tag, line);
    if (tag.kind == XmlTag::Kind::other) return std::nullopt;
    if (tag.kind == XmlTag::Kind::start) ++depth_;
    element_ = next_element(*element_);
    if (element_ != nullptr && element_->ToElement()->Name() == tag.name) return std::nullopt;
    return MisreadTag{line, fmt::format("<{}> cannot be read in one way only", tag.name),
                      "mend the tags before it: the text is not well-formed XML"};
  }

 private:
  std::optional<MisreadTag> take_end(const XmlTag& tag, int line) {
    if (auto misread = judge_end(tag, line)) return misread;
    if (--depth_ >= 0) return std::nullopt;
    return MisreadTag{line, fmt::format("</{}> closes nothing: no element is open here", tag.name),
                      "remove it, or the end tag too many before it"};
  }

  const tinyxml2::XMLNode* element_;
  int depth_ = 0;
};

}  // namespace

std::optional<MisreadTag> find_misread_tag(const tinyxml2::XMLDocument& document,
                                           std::string_view text) {
  TagComparison comparison(document);
  int line = 1;
  for (std::size_t at = 0;;) {
    const std::size_t before = at;
    const std::size_t opening = std::min(text.find('<', at), text.size());
    const auto tag = next_tag(text, at);
    if (!tag) return std::nullopt;
    const auto place = [&](std::size_t to) { return text.begin() + static_cast<long>(to); };
    line += static_cast<int>(std::count(place(before), place(opening), '\n'));
    if (auto misread = comparison.take(*tag, line)) return misread;
    line += static_cast<int>(std::count(place(opening), place(at), '\n'));
  }
}

}  // namespace treeline
