#include <algorithm>
#include <map>
#include <string>

#include "description/inertias.hpp"
#include "inspect/inspect_robot.hpp"

namespace treeline {
namespace {

std::map<std::string, std::size_t> places_of(const Report& report) {
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < report.links.size(); ++i) places[report.links[i].name] = i;
  return places;
}

}  // namespace

void inspect_inertias(const Robot& robot, const Scene& scene, Report& report) {
  const auto places = places_of(report);
  std::vector<int> faulty;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const auto& inertial = robot.links[i].inertial;
    if (!inertial) continue;
    LinkReport& link = report.links[places.at(robot.links[i].name)];
    link.flat = name_of_flat_body(*inertial);
    link.nearest = nearest_possible_inertia(*inertial);
    if (link.nearest) faulty.push_back(static_cast<int>(i));
  }
  for (const int i : find_felt_faults(robot, scene, faulty)) {
    report.links[places.at(robot.links[static_cast<std::size_t>(i)].name)].felt = true;
  }
}

std::vector<InertiaRepair> list_repairs(const Robot& robot, const Report& report) {
  const auto places = places_of(report);
  std::vector<InertiaRepair> repairs;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const LinkReport& link = report.links[places.at(robot.links[i].name)];
    if (link.felt && link.nearest) repairs.push_back({static_cast<int>(i), *link.nearest});
  }
  return repairs;
}

}  // namespace treeline
