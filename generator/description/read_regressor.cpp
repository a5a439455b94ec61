#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "description/read_keys.hpp"
#include "description/read_scene_point.hpp"

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

/// Whether the link has columns of its own; else with an error.
bool has_own_columns(const SceneElement& item, const std::string& name, const Robot& robot,
                     const Scene& scene) {
  const std::string carrier = find_carrier(robot, scene, name);
  if (carrier == name) return true;
  item.error(fmt::format("the link \"{}\" is fixed to \"{}\", whose parameters contain its own",
                         name, carrier),
             fmt::format("name \"{}\"", carrier));
  return false;
}

/// Reads one link or several into `listed`, of which `accept(item, name)` says which may be there.
template <class Accept>
void read_links(const SceneElement& element, const Robot& robot, const Scene& scene,
                std::vector<std::string>& listed, const Accept& accept) {
  for (const SceneElement& item : one_or_more(element)) {
    const auto name = item.text();
    if (!name || find_moving_link(item, *name, robot, scene) == nullptr) continue;
    if (!accept(item, *name)) continue;
    if (std::find(listed.begin(), listed.end(), *name) != listed.end()) {
      item.error(fmt::format("the link \"{}\" is listed twice", *name), "list it once");
    } else {
      listed.push_back(*name);
    }
  }
}

/// Reads `parameters: all`, `base` or `none`, and the keys that these permit.
void read_inertial(const SceneFields& fields, const Robot& robot, Scene& scene) {
  SceneRegressor& asked = scene.regressor;
  if (const auto found = fields.find("parameters"); found != fields.end()) {
    const auto chosen = found->second.choice({"all", "base", "none"}).value_or(0);
    asked.base = chosen == 1;
    asked.none = chosen == 2;
  }
  if (const auto links = fields.find("links"); links != fields.end()) {
    read_links(links->second, robot, scene, asked.links, [&](const auto& item, const auto& name) {
      return has_own_columns(item, name, robot, scene);
    });
    if (links->second.is_list() && links->second.items().empty()) {
      links->second.error("no link is listed",
                          "leave out the key for all that move, or write parameters: none");
    } else if (asked.base) {
      links->second.error("base parameters combine those of several links",
                          "leave out links, or write parameters: all");
    } else if (asked.none) {
      links->second.error("parameters: none has no columns of links",
                          "leave out links, or write parameters: all");
    }
  }
  if (const auto payload = fields.find("payload"); payload != fields.end()) {
    read_links(payload->second, robot, scene, asked.payloads,
               [](const auto&, const auto&) { return true; });
    if (asked.base) {
      payload->second.error("a payload cannot be told from base parameters of its link",
                            "write parameters: none for the payload of a robot that is known");
    }
  }
}

void read_friction(const SceneFields& fields, SceneRegressor& asked) {
  if (const auto friction = fields.find("friction"); friction != fields.end()) {
    const auto chosen = friction->second.choice({"false", "true", "viscous", "coulomb"});
    asked.friction = chosen.value_or(0) > 0;
    asked.coulomb = chosen == 3;
  }
  const auto width = fields.find("width");
  if (width == fields.end()) return;
  const double own = width->second.number().value_or(asked.width);
  if (!asked.coulomb) {
    width->second.error("only Coulomb friction has a width", "write friction: coulomb");
  } else if (!(own > 0)) {
    width->second.error(fmt::format("{} is not positive", own), "give rad/s or m/s");
  } else {
    asked.width = own;
  }
}

bool has_columns(const SceneRegressor& asked) {
  return !asked.none || !asked.payloads.empty() || asked.rotors || asked.friction;
}

}  // namespace

void read_regressor(const SceneElement& element, const Robot& robot, Scene& scene) {
  const auto fields =
      element.fields({"parameters", "links", "payload", "rotors", "friction", "width"});
  read_inertial(fields, robot, scene);
  if (const auto rotors = fields.find("rotors"); rotors != fields.end()) {
    scene.regressor.rotors = rotors->second.choice({"false", "true"}) == 1;
  }
  read_friction(fields, scene.regressor);
  if (has_columns(scene.regressor)) return;
  element.error("with parameters: none and nothing else, regressors have no column",
                "add payload, rotors or friction");
}

void check_regressor_used(const SceneElement& top, const Scene& scene) {
  const SceneRegressor& asked = scene.regressor;
  const bool plain = !asked.base && !asked.none && !asked.rotors && !asked.friction &&
                     asked.links.empty() && asked.payloads.empty();
  if (plain || scene.inputs.base_parameters) return;
  if (std::any_of(scene.functions.begin(), scene.functions.end(), is_regressor)) return;
  top.warn("regressor says which columns to have, but no function has them",
           "add inverse_dynamics_regressor or energy_regressor to functions");
}

}  // namespace treeline
