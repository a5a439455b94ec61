#include "inspect/repair_urdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "description/find_inertia_tags.hpp"

namespace treeline {
namespace {

struct Moment {
  const char* name;
  const char* mirrored;  ///< another name of the same product; empty for none
  double Inertial::*value;
};
constexpr std::array<Moment, 6> kMoments{{{"ixx", "", &Inertial::ixx},
                                          {"ixy", "iyx", &Inertial::ixy},
                                          {"ixz", "izx", &Inertial::ixz},
                                          {"iyy", "", &Inertial::iyy},
                                          {"iyz", "izy", &Inertial::iyz},
                                          {"izz", "", &Inertial::izz}}};

void edit_tag(const XmlTag& tag, const Inertial& old, const Inertial& repaired,
              const std::string& text, std::vector<TextEdit>& edits) {
  for (const XmlAttribute& attribute : tag.attributes) {
    for (const Moment& moment : kMoments) {
      if (attribute.name != moment.name && attribute.name != moment.mirrored) continue;
      if (old.*moment.value == repaired.*moment.value) continue;
      edits.push_back({static_cast<std::size_t>(attribute.value.data() - text.data()),
                       attribute.value.size(), fmt::format("{}", repaired.*moment.value)});
    }
  }
}

}  // namespace

std::vector<TextEdit> edit_inertias(const Robot& robot, const std::string& text,
                                    const std::vector<InertiaRepair>& repairs) {
  const auto tags = find_inertia_tags(text);
  std::vector<TextEdit> edits;
  for (const InertiaRepair& repair : repairs) {
    const auto link = static_cast<std::size_t>(repair.link);
    if (link >= tags.size() || !tags[link] || !robot.links[link].inertial) continue;
    edit_tag(*tags[link], *robot.links[link].inertial, repair.inertial, text, edits);
  }
  std::sort(edits.begin(), edits.end(),
            [](const TextEdit& a, const TextEdit& b) { return a.at < b.at; });
  return edits;
}

}  // namespace treeline
