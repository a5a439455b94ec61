#include "description/scan_xml.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "description/xml_faults.hpp"

namespace treeline {
namespace {

constexpr std::string_view kSpace = " \t\r\n\f\v";

/// Skips what reaches from `opening` at `at` to the end of `closing`, or of the text.
void skip_past(std::string_view text, std::size_t& at, std::size_t opening,
               std::string_view closing) {
  const auto end = text.find(closing, at + opening);
  at = end == std::string_view::npos ? text.size() : end + closing.size();
}

/// Moves `at` past a comment, CDATA, a declaration or a DOCTYPE; false when there is none.
bool skip_other(std::string_view text, std::size_t& at) {
  const std::string_view rest = text.substr(at);
  if (rest.starts_with("<!--")) {
    skip_past(text, at, 4, "-->");
  } else if (rest.starts_with("<![CDATA[")) {
    skip_past(text, at, 9, "]]>");
  } else if (rest.starts_with("<?")) {
    skip_past(text, at, 2, "?>");
  } else if (rest.starts_with("<!")) {
    skip_past(text, at, 2, ">");
  } else {
    return false;
  }
  return true;
}

std::size_t skip_space(std::string_view text, std::size_t at) {
  return std::min(text.find_first_not_of(kSpace, at), text.size());
}

std::string_view take_name(std::string_view text, std::size_t& at) {
  const std::size_t end = std::min(text.find_first_of(" \t\r\n\f\v/>=\"'<", at), text.size());
  const std::string_view name = text.substr(at, end - at);
  at = end;
  return name;
}

/// The attribute that starts at `at`, which moves behind its value.
XmlAttribute take_attribute(std::string_view text, std::size_t& at) {
  XmlAttribute attribute{take_name(text, at), {}};
  at = skip_space(text, at);
  if (at < text.size() && text[at] == '=') at = skip_space(text, at + 1);
  if (at >= text.size() || (text[at] != '"' && text[at] != '\'')) return attribute;
  const std::size_t end = std::min(text.find(text[at], at + 1), text.size());
  attribute.value = text.substr(at + 1, end - at - 1);
  at = std::min(end + 1, text.size());
  return attribute;
}

}  // namespace

std::optional<XmlTag> next_tag(std::string_view text, std::size_t& at) {
  at = std::min(text.find('<', at), text.size());
  if (at == text.size()) return std::nullopt;
  XmlTag tag;
  if (skip_other(text, at)) return tag;
  // XML has no space here; the reader of it takes it nonetheless.
  at = skip_space(text, at + 1);
  tag.kind = XmlTag::Kind::start;
  if (at < text.size() && text[at] == '/') {
    tag.kind = XmlTag::Kind::end;
    ++at;
  }
  tag.name = take_name(text, at);
  for (at = skip_space(text, at); at < text.size(); at = skip_space(text, at)) {
    const char c = text[at];
    if (c == '>' || c == '<') break;
    if (c == '/') {
      tag.kind = tag.kind == XmlTag::Kind::start ? XmlTag::Kind::empty : tag.kind;
      tag.has_slash = true;
      ++at;
      continue;
    }
    const std::size_t before = at;
    const XmlAttribute attribute = take_attribute(text, at);
    if (at == before) ++at;
    if (++tag.attribute_count <= kKeptAttributes) tag.attributes.push_back(attribute);
  }
  if (at < text.size() && text[at] == '>') ++at;
  return tag;
}

namespace {

/// Follows the tags of a URDF down to the inertias.
class InertiaSearch {
 public:
  void enter(const XmlTag& tag) {
    ++depth_;
    if (depth_ == 2 && tag.name == "link") {
      found_.emplace_back();
      inertials_ = 0;
      in_link_ = true;
    } else if (depth_ == 2) {
      in_link_ = false;
    } else if (depth_ == 3) {
      in_first_inertial_ = in_link_ && tag.name == "inertial" && ++inertials_ == 1;
    } else if (depth_ == 4 && in_first_inertial_ && tag.name == "inertia" && !found_.back()) {
      found_.back() = tag;
    }
  }

  void leave() { --depth_; }

  [[nodiscard]] std::vector<std::optional<XmlTag>> found() const { return found_; }

 private:
  int depth_ = 0, inertials_ = 0;
  bool in_link_ = false, in_first_inertial_ = false;
  std::vector<std::optional<XmlTag>> found_;
};

}  // namespace

std::vector<std::optional<XmlTag>> find_inertia_tags(std::string_view text) {
  InertiaSearch search;
  for (std::size_t at = 0; const auto tag = next_tag(text, at);) {
    if (tag->kind == XmlTag::Kind::start || tag->kind == XmlTag::Kind::empty) search.enter(*tag);
    if (tag->kind == XmlTag::Kind::end || tag->kind == XmlTag::Kind::empty) search.leave();
  }
  return search.found();
}

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
