#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "description/read_number.hpp"
#include "description/urdf_element.hpp"
#include "text/suggest_name.hpp"

// What stands in an element that URDF does not have there.

namespace treeline {
namespace {

using Names = std::initializer_list<std::string_view>;

/// Elements on which the motion depends.
constexpr std::array<std::string_view, 13> kOfMotion = {
    "robot", "link",  "joint",    "inertial", "origin", "mass", "inertia",
    "axis",  "limit", "dynamics", "mimic",    "parent", "child"};

/// Elements whose attributes are numbers of the motion. An attribute that nobody reads, such as the
/// ratio of a mimic or the quaternion of an origin, may be meant to be one of these numbers.
constexpr std::array<std::string_view, 5> kOfNumbers = {"origin", "mass", "inertia", "axis",
                                                        "mimic"};

constexpr const char* kRemoveIfMeant = "remove it if it was meant to change the robot's motion";

template <class List>
bool is_among(std::string_view name, const List& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The name that this one is but for capitals; empty if there is none.
std::string_view find_but_for_capitals(std::string_view name, Names names) {
  const auto same_letter = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
  };
  for (const std::string_view each : names) {
    if (std::equal(name.begin(), name.end(), each.begin(), each.end(), same_letter)) return each;
  }
  return {};
}

/// `did you mean` one of these, on which the motion depends.
std::string suggest(std::string_view name, Names names, bool only_of_motion) {
  std::vector<std::string> known;
  for (const std::string_view each : names) {
    if (!only_of_motion || is_among(each, kOfMotion)) known.emplace_back(each);
  }
  return find_near_name(name, known);
}

/// Attributes by which other formats turn what URDF turns by rpy.
bool is_quaternion(std::string_view name) {
  const auto has = [&](std::string_view part) { return name.find(part) != std::string_view::npos; };
  return has("quat") || has("wxyz") || has("xyzw");
}

}  // namespace

std::string UrdfElement::kind() const {
  std::string kind;
  for (const tinyxml2::XMLNode* node = xml_; node != nullptr && node->ToElement();
       node = node->Parent()) {
    kind = std::string("/") + node->Value() + kind;
  }
  return kind;
}

void UrdfElement::only_attributes(Names known) const {
  for (const auto* attribute = xml_->FirstAttribute(); attribute; attribute = attribute->Next()) {
    const std::string_view name = attribute->Name();
    // A prefix says that the attribute is another program's own.
    const bool foreign = name == "xmlns" || name.find(':') != std::string_view::npos;
    if (foreign || is_among(name, known)) continue;
    const std::string_view meant = find_but_for_capitals(name, known);
    if (!meant.empty()) {
      reading_->report(
          Severity::error, attribute->GetLineNum(), path_,
          fmt::format("\"{}\" is not the attribute \"{}\": capitals count in XML", name, meant),
          fmt::format("write {}=\"{}\"", meant, attribute->Value()));
      continue;
    }
    const auto* const parent = xml_->Parent()->ToElement();  // the looks have origins, too
    const bool moves = is_among(this->name(), kOfNumbers) && parent != nullptr &&
                       is_among(parent->Name(), kOfMotion);
    const std::string near = is_quaternion(name) ? "remove it, and give the turn as rpy in radians"
                                                 : suggest(name, known, false);
    reading_->pass_over(
        Severity::warning, fmt::format("{}@{}", kind(), name), attribute->GetLineNum(), path_,
        fmt::format("the attribute \"{}\" is not part of URDF and is ignored", name),
        near.empty() ? kRemoveIfMeant : near,
        near.empty() && !moves ? Minor::attribute : Minor::none);
  }
}

void UrdfElement::pass_over_child(const UrdfElement& child, Names known) const {
  const std::string_view name = child.name();
  const auto pass_over = [&](std::string fault, const std::string& remedy, Minor minor) {
    reading_->pass_over(Severity::warning, fmt::format("{}/{}", kind(), name), child.line(), path_,
                        std::move(fault), remedy, minor);
  };
  const std::string_view meant = find_but_for_capitals(name, known);
  const std::string near = suggest(name, known, true);
  if (is_among(meant, kOfMotion)) {
    reading_->report(Severity::error, child.line(), path_,
                     fmt::format("<{}> is not <{}>: capitals count in XML", name, meant),
                     fmt::format("write <{}>", meant));
  } else if (is_among(name, kOfMotion)) {
    pass_over(fmt::format("<{}> has no place inside <{}> and is ignored", name, this->name()),
              "move it to where URDF has it, or remove it", Minor::none);
  } else {
    pass_over(fmt::format("<{}> is not part of URDF and is ignored", name),
              near.empty() ? kRemoveIfMeant : near, near.empty() ? Minor::element : Minor::none);
  }
}

void UrdfElement::only_children(Names known) const {
  no_text();
  for (const auto* element = xml_->FirstChildElement(); element != nullptr;
       element = element->NextSiblingElement()) {
    if (!is_among(element->Name(), known)) pass_over_child(as_child(*element), known);
  }
}

void UrdfElement::holds_only_attributes(Names known) const {
  only_attributes(known);
  bool has_numbers = false;
  for (const auto* node = xml_->FirstChild(); node != nullptr; node = node->NextSibling()) {
    const auto numbers = node->ToText() != nullptr ? read_numbers(node->Value()) : std::nullopt;
    if (numbers && !numbers->empty()) {
      has_numbers = true;
      reading_->report(Severity::error, node->GetLineNum(), path_,
                       fmt::format("{} stands inside <{}>, where nothing reads it",
                                   trimmed(node->Value()), name()),
                       fmt::format("give it as an attribute: <{} {}=\"...\"/>", name(),
                                   fmt::join(known, "=\"...\" ")));
    }
    if (node->ToElement() == nullptr) continue;
    const UrdfElement child = as_child(*node->ToElement());
    const std::string_view meant = find_but_for_capitals(child.name(), known);
    if (meant.empty()) {
      pass_over_child(child, {});
    } else {
      child.error(fmt::format("an element inside <{}>; URDF has it as an attribute", name()),
                  fmt::format("write <{} {}=\"...\"/>", name(), meant));
    }
  }
  if (!has_numbers) no_text();
}

void UrdfElement::no_text() const {
  for (const auto* node = xml_->FirstChild(); node != nullptr; node = node->NextSibling()) {
    const auto* text = node->ToText();
    if (text == nullptr || trimmed(text->Value()).empty()) continue;
    reading_->pass_over(Severity::warning, kind() + "#text", node->GetLineNum(), path_,
                        "text stands between the elements and is ignored", "remove it",
                        Minor::text);
  }
}

}  // namespace treeline
