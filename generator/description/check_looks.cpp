#include <fmt/format.h>

#include <algorithm>

#include "description/urdf_parts.hpp"

namespace treeline {
namespace {

constexpr std::array<std::string_view, 5> kLooks = {"link", "visual", "collision", "geometry",
                                                    "material"};
constexpr std::array<std::string_view, 5> kShapes = {"box", "cylinder", "capsule", "sphere",
                                                     "mesh"};
constexpr std::array<std::string_view, 8> kHoldAttributes = {
    "color", "texture", "origin", "box", "cylinder", "capsule", "sphere", "mesh"};

template <class List>
bool is_one_of(std::string_view name, const List& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void pass_over_content(const UrdfElement& element) {
  element.no_text();
  for (const auto* inside = element.xml().FirstChildElement(); inside != nullptr;
       inside = inside->NextSiblingElement()) {
    element.reading().pass_over(Severity::warning,
                                fmt::format("{}/{}", element.name(), inside->Name()),
                                inside->GetLineNum(), element.path(),
                                fmt::format("<{}> stands inside <{}>, where nothing reads it",
                                            inside->Name(), element.name()),
                                fmt::format("if an attribute is meant, write <{} {}=\"...\"/>",
                                            element.name(), inside->Name()));
  }
}

/// A geometry is one shape: readers take the first.
void pass_over_second_shape(const UrdfElement& geometry) {
  const auto* const first = geometry.xml().FirstChildElement();
  const auto* const second = first == nullptr ? nullptr : first->NextSiblingElement();
  if (second == nullptr) return;
  geometry.reading().pass_over(
      Severity::warning, fmt::format("geometry/{}", second->Name()), second->GetLineNum(),
      geometry.path(),
      fmt::format("<{}> stands behind the shape of its <geometry> and is ignored", second->Name()),
      is_one_of(second->Name(), kShapes) ? "give each shape a <visual> or <collision> of its own"
                                         : "move it to where URDF has it, or remove it");
}

}  // namespace

void check_looks(const UrdfElement& robot) {
  for (const auto* xml = robot.xml().FirstChildElement(); xml; xml = xml->NextSiblingElement()) {
    const UrdfElement element = robot.as_child(*xml);
    if (is_one_of(element.name(), kHoldAttributes)) {
      pass_over_content(element);
    } else if (is_one_of(element.name(), kLooks)) {
      if (element.name() == "geometry") pass_over_second_shape(element);
      check_looks(element);
    }
  }
}

}  // namespace treeline
