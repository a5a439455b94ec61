#include "description/read_regressor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "description/count_freedoms.hpp"
#include "description/list_links.hpp"

namespace treeline {
namespace {

const Joint* find_joint_of(const Robot& robot, const std::string& link) {
  const auto found =
      std::find_if(robot.joints.begin(), robot.joints.end(), [&](const Joint& joint) {
        return robot.links[static_cast<std::size_t>(joint.child)].name == link;
      });
  return found == robot.joints.end() ? nullptr : &*found;
}

/// Whether the scene holds the joint, or the one that it follows.
bool is_held(const Robot& robot, const Scene& scene, const Joint& joint) {
  if (!info_of(joint.type).moves() || scene.locked.contains(joint.name)) return true;
  return joint.mimic &&
         is_held(robot, scene, robot.joints[static_cast<std::size_t>(joint.mimic->joint)]);
}

/// The link of whose body the link is part: the nearest that moves against its parent.
std::string find_carrier(const Robot& robot, const Scene& scene, std::string link) {
  for (const Joint* joint = find_joint_of(robot, link);
       joint != nullptr && is_held(robot, scene, *joint); joint = find_joint_of(robot, link)) {
    link = robot.links[static_cast<std::size_t>(joint->parent)].name;
  }
  return link;
}

/// Whether the link has columns; else with an error.
bool check_link(const SceneElement& item, const std::string& name, const Robot& robot,
                const Scene& scene) {
  const auto& listed = scene.regressor.links;
  if (std::none_of(robot.links.begin(), robot.links.end(),
                   [&](const Link& link) { return link.name == name; })) {
    item.error(fmt::format("the robot has no link \"{}\"", name), suggest_link(name, robot));
  } else if (find_freedoms_of_link(robot, scene, name).empty()) {
    item.error(fmt::format("the link \"{}\" cannot move", name),
               "name a link behind a joint that moves");
  } else if (const std::string carrier = find_carrier(robot, scene, name); carrier != name) {
    item.error(fmt::format("the link \"{}\" is fixed to \"{}\", whose parameters contain its own",
                           name, carrier),
               fmt::format("name \"{}\"", carrier));
  } else if (std::find(listed.begin(), listed.end(), name) != listed.end()) {
    item.error(fmt::format("the link \"{}\" is listed twice", name), "list it once");
  } else {
    return true;
  }
  return false;
}

void read_links(const SceneElement& element, const Robot& robot, Scene& scene) {
  const std::vector<SceneElement> items =
      element.is_list() ? element.items() : std::vector<SceneElement>{element};
  for (const SceneElement& item : items) {
    const auto name = item.text();
    if (name && check_link(item, *name, robot, scene)) scene.regressor.links.push_back(*name);
  }
  if (items.empty()) element.error("no link is listed", "leave out the key for all that move");
}

}  // namespace

void read_regressor(const SceneElement& element, const Robot& robot, Scene& scene) {
  const auto fields = element.fields({"parameters", "links", "rotors", "friction"});
  const auto is_second = [&](const char* key, const std::vector<std::string>& choices) {
    const auto found = fields.find(key);
    return found != fields.end() && found->second.choice(choices) == 1;
  };
  scene.regressor.base = is_second("parameters", {"all", "base"});
  scene.regressor.rotors = is_second("rotors", {"false", "true"});
  scene.regressor.friction = is_second("friction", {"false", "true"});
  const auto links = fields.find("links");
  if (links == fields.end()) return;
  read_links(links->second, robot, scene);
  if (!scene.regressor.base) return;
  links->second.error("base parameters combine those of several links",
                      "leave out links, or write parameters: all");
}

void check_regressor_used(const SceneElement& top, const Scene& scene) {
  const SceneRegressor& asked = scene.regressor;
  if (!asked.base && !asked.rotors && !asked.friction && asked.links.empty()) return;
  if (std::any_of(scene.functions.begin(), scene.functions.end(), is_regressor)) return;
  top.warn("regressor says which columns to have, but no function has them",
           "add inverse_dynamics_regressor or energy_regressor to functions");
}

}  // namespace treeline
