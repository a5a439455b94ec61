#include <nlohmann/json.hpp>

#include "comparison/difference.hpp"
#include "text/json_text.hpp"

namespace treeline {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const LinkDifference& link, bool differs) {
  return {{"first", link.first},
          {"second", link.second},
          {"differs", differs},
          {"position", link.position},
          {"rotation", link.rotation},
          {"first_mass", link.first_mass},
          {"second_mass", link.second_mass},
          {"mass", link.mass},
          {"centre", link.centre},
          {"inertia", link.inertia}};
}

Json to_json(const JointDifference& joint, bool differs) {
  return {{"first", joint.first},
          {"second", joint.second},
          {"differs", differs},
          {"faults", joint.faults}};
}

Json to_json(const Deviation& deviation) {
  return {{"relative", deviation.relative},
          {"absolute", deviation.absolute},
          {"unit", deviation.unit},
          {"joint", deviation.joint}};
}

Json to_json(const DynamicsDifference& dynamics) {
  return {{"coordinates", dynamics.coordinates},
          {"mass_matrix", dynamics.mass_matrix},
          {"row", dynamics.row},
          {"column", dynamics.column},
          {"gravity", to_json(dynamics.gravity)},
          {"inverse_dynamics", to_json(dynamics.inverse_dynamics)}};
}

}  // namespace

std::string print_json(const RobotDifference& d) {
  Json links = Json::array(), joints = Json::array();
  for (const auto& link : d.links) links.push_back(to_json(link, d.differs(link)));
  for (const auto& joint : d.joints) joints.push_back(to_json(joint, d.differs(joint)));
  const Json json{
      {"differs", d.differs()},
      {"tolerance", d.tolerance},
      {"first", {{"file", d.first_file}, {"name", d.first_name}, {"mass", d.first_mass}}},
      {"second", {{"file", d.second_file}, {"name", d.second_name}, {"mass", d.second_mass}}},
      {"base", d.base == Base::floating ? "floating" : "fixed"},
      {"states", d.states},
      {"reference", d.reference},
      {"links_only_in_first", d.links_only_in_first},
      {"links_only_in_second", d.links_only_in_second},
      {"joints_only_in_first", d.joints_only_in_first},
      {"joints_only_in_second", d.joints_only_in_second},
      {"links", links},
      {"joints", joints},
      {"dynamics", to_json(d.dynamics)}};
  // Names of files need not be UTF-8.
  return json_text(json);
}

}  // namespace treeline
