#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "description/urdf_parts.hpp"
#include "text/suggest_name.hpp"

namespace treeline {
namespace {

std::string remedy_for_unknown(const std::string& name, const Robot& robot) {
  const auto same_name = [&](const Link& link) { return link.name == name; };
  if (std::any_of(robot.links.begin(), robot.links.end(), same_name)) {
    return "this is a link: name the joint";
  }
  std::vector<std::string> names;
  for (const Joint& joint : robot.joints) names.push_back(joint.name);
  const std::string suggestion = suggest_name(name, names, "the joints are");
  return suggestion.empty() ? "name a joint of this robot" : suggestion;
}

UrdfElement mimic_of(const NamedJoint& named) {
  return named.element.as_child(*named.element.xml().FirstChildElement("mimic"));
}

/// Sets Mimic::joint to the joint named in the file.
bool find_followed(const NamedJoint& named, const std::map<std::string, int>& indices, Robot& robot,
                   Mimic& mimic) {
  const auto found = indices.find(*named.mimicked);
  if (found == indices.end()) {
    mimic_of(named).error(fmt::format("the mimicked joint \"{}\" is not defined", *named.mimicked),
                          remedy_for_unknown(*named.mimicked, robot));
    return false;
  }
  const Joint& followed = robot.joints[static_cast<std::size_t>(found->second)];
  if (!info_of(followed.type).has_one_freedom()) {
    mimic_of(named).error(
        fmt::format("the mimicked joint \"{}\" has not one degree of freedom", followed.name),
        "mimic a revolute, continuous or prismatic joint");
    return false;
  }
  mimic.joint = found->second;
  return true;
}

/// The chain of mimics from joint `start`, ending in a joint that is none; empty for a cycle.
std::vector<std::size_t> follow_chain(std::size_t start, const Robot& robot) {
  std::vector<std::size_t> chain{start};
  while (robot.joints[chain.back()].mimic) {
    if (chain.size() > robot.joints.size()) return {};
    chain.push_back(static_cast<std::size_t>(robot.joints[chain.back()].mimic->joint));
  }
  return chain;
}

std::optional<Mimic> resolve(std::size_t start, const NamedJoint& named, const Robot& robot) {
  const std::vector<std::size_t> chain = follow_chain(start, robot);
  if (chain.empty()) {
    const bool itself = robot.joints[start].mimic->joint == static_cast<int>(start);
    mimic_of(named).error(
        itself ? "the joint mimics itself" : "the mimics follow each other in a circle",
        "let one of them be independent");
    return std::nullopt;
  }
  Mimic total{static_cast<int>(chain.back()), 1, 0};
  // q_a = m_a (m_b q_c + o_b) + o_a, taken from the far end.
  for (std::size_t i = chain.size() - 1; i-- > 0;) {
    const Mimic& step = *robot.joints[chain[i]].mimic;
    total.offset = step.multiplier * total.offset + step.offset;
    total.multiplier *= step.multiplier;
  }
  if (!std::isfinite(total.offset) || !std::isfinite(total.multiplier)) {
    mimic_of(named).error("the multipliers along the chain of mimics overflow", "use smaller ones");
    return std::nullopt;
  }
  return total;
}

}  // namespace

bool resolve_mimics(const std::vector<NamedJoint>& joints, Robot& robot) {
  std::map<std::string, int> indices;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    indices.try_emplace(joints[i].joint.name, static_cast<int>(i));
  }
  bool ok = true;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].mimicked)
      ok = find_followed(joints[i], indices, robot, *robot.joints[i].mimic) && ok;
  }
  if (!ok) return false;
  const Robot as_in_file = robot;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (!joints[i].mimicked) continue;
    const auto resolved = resolve(i, joints[i], as_in_file);
    ok = ok && resolved.has_value();
    if (resolved) robot.joints[i].mimic = resolved;
  }
  return ok;
}

}  // namespace treeline
