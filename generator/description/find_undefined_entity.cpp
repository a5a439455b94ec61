#include <algorithm>
#include <array>

#include "description/scan_xml.hpp"
#include "description/xml_faults.hpp"

namespace treeline {
namespace {

constexpr std::array<std::string_view, 5> kDefined = {"amp", "lt", "gt", "quot", "apos"};

bool begins_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':';
}
bool continues_name(char c) {
  return begins_name(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
}

/// The first `&name;` in a value; empty if there is none.
std::string_view next_reference(std::string_view value) {
  for (std::size_t at = value.find('&'); at != std::string_view::npos;
       at = value.find('&', at + 1)) {
    std::size_t end = at + 1;
    if (end == value.size() || !begins_name(value[end])) continue;
    while (end < value.size() && continues_name(value[end])) ++end;
    if (end < value.size() && value[end] == ';') return value.substr(at, end + 1 - at);
  }
  return {};
}

}  // namespace

std::optional<UndefinedEntities> find_undefined_entities(std::string_view text) {
  UndefinedEntities found;
  std::size_t place = 0;
  while (const auto tag = next_tag(text, place)) {
    for (const XmlAttribute& attribute : tag->attributes) {
      std::string_view rest = attribute.value;
      for (std::string_view reference = next_reference(rest); !reference.empty();
           reference = next_reference(rest)) {
        rest.remove_prefix(
            static_cast<std::size_t>(reference.data() + reference.size() - rest.data()));
        const std::string_view name = reference.substr(1, reference.size() - 2);
        if (std::find(kDefined.begin(), kDefined.end(), name) != kDefined.end()) continue;
        if (++found.count > 1) continue;
        found.line = 1 + static_cast<int>(std::count(text.data(), reference.data(), '\n'));
        found.attribute = attribute.name;
        found.first = reference;
      }
    }
  }
  return found.count > 0 ? std::optional(found) : std::nullopt;
}

}  // namespace treeline
