#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "description/read_urdf.hpp"
#include "description/scan_xml.hpp"
#include "inspect/inspect_robot.hpp"

namespace treeline {
namespace {

struct Moment {
  const char* name;
  const char* mirrored;  ///< other name of the same product; empty if there is none
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

bool has_moments(const Inertial& a, const Inertial& b) {
  return std::all_of(kMoments.begin(), kMoments.end(),
                     [&](const Moment& moment) { return a.*moment.value == b.*moment.value; });
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

bool has_repairs(const std::string& text, const Robot& robot,
                 const std::vector<InertiaRepair>& repairs) {
  Diagnostics diagnostics;
  const auto read = parse_urdf(text, "repaired.urdf", diagnostics);
  if (!read || read->links.size() != robot.links.size()) return false;
  std::vector<std::optional<Inertial>> asked;
  for (const Link& link : robot.links) asked.push_back(link.inertial);
  for (const InertiaRepair& repair : repairs) {
    asked[static_cast<std::size_t>(repair.link)] = repair.inertial;
  }
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (asked[i].has_value() != read->links[i].inertial.has_value()) return false;
    if (asked[i] && !has_moments(*asked[i], *read->links[i].inertial)) return false;
  }
  return true;
}

}  // namespace treeline
