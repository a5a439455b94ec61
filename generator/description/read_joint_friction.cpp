#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "description/read_keys.hpp"
#include "description/read_scene_point.hpp"

namespace treeline {
namespace {

bool states_friction(const Joint& joint) {
  return joint.damping != 0 || joint.friction != 0;
}

std::string count_joints(int count) {
  return count == 1 ? "a joint" : fmt::format("{} joints", count);
}

bool has_one_motion(const Joint& joint, const Scene& scene) {
  return info_of(joint.type).has_one_freedom() && !scene.locked.contains(joint.name);
}

/// A number of a map that is not below 0 (above 0 if `positive`); nothing if it is not there.
std::optional<double> read_size(const SceneFields& fields, const char* key, bool positive) {
  const auto found = fields.find(key);
  if (found == fields.end()) return std::nullopt;
  const auto value = found->second.number();
  if (!value || *value > 0 || (*value == 0 && !positive)) return value;
  found->second.error(fmt::format("{} is {}", *value, positive ? "not positive" : "negative"),
                      "friction opposes motion; give a positive number");
  return std::nullopt;
}

/// Reads the scene's friction joint by joint.
class FrictionReader {
 public:
  FrictionReader(const SceneElement& element, const Robot& robot, Scene& scene)
      : element_(element), robot_(robot), scene_(scene) {}

  void read() {
    if (element_.is("none")) return;
    SceneFields fields;
    if (element_.is_map()) {
      fields = element_.fields({"model", "width", "implicit", "joints"});
      read_settings(fields);
    } else {
      read_model(element_, {"none", "viscous", "coulomb"});
    }
    if (!knows_model_) return;  // whatever else would be said is about another model
    take_from_file();
    if (const auto joints = fields.find("joints"); joints != fields.end()) {
      for (const auto& [name, value] : joints->second.entries()) read_joint(name, value);
    }
    check();
    std::erase_if(scene_.joint_friction, [](const auto& entry) {
      return entry.second.damping <= 0 && entry.second.friction <= 0;
    });
  }

 private:
  void read_model(const SceneElement& element, const std::vector<std::string>& choices) {
    const auto chosen = element.choice(choices);
    knows_model_ = chosen.has_value();
    coulomb_ = chosen && choices[*chosen] == "coulomb";
  }

  void read_settings(const SceneFields& fields) {
    const auto model = fields.find("model");
    if (model == fields.end()) {
      element_.error("the key \"model\" is missing", "write model: viscous or model: coulomb");
      knows_model_ = false;
    } else {
      read_model(model->second, {"viscous", "coulomb"});
    }
    if (!knows_model_) return;
    refuse_without_coulomb(fields);
    width_ = read_size(fields, "width", true).value_or(kFrictionWidth);
    if (const auto implicit = fields.find("implicit"); implicit != fields.end()) {
      scene_.implicit_friction = implicit->second.choice({"false", "true"}) == 1;
    }
  }

  void refuse_without_coulomb(const SceneFields& fields) const {
    for (const char* key : {"friction", "width"}) {
      const auto found = fields.find(key);
      if (coulomb_ || found == fields.end()) continue;
      found->second.error("viscous friction has no Coulomb part",
                          "write model: coulomb, or remove this");
    }
  }

  void take_from_file() {
    int left_out = 0;
    for (const Joint& joint : robot_.joints) {
      if (!states_friction(joint)) continue;
      if (!has_one_motion(joint, scene_)) {
        if (info_of(joint.type).moves() && !scene_.locked.contains(joint.name)) {
          element_.note(fmt::format("friction of \"{}\", a {} joint, is left out", joint.name,
                                    info_of(joint.type).name),
                        "only joints of one degree of freedom have friction");
        }
        continue;
      }
      scene_.joint_friction[joint.name] = {joint.damping, coulomb_ ? joint.friction : 0, width_};
      if (!coulomb_ && joint.friction != 0) ++left_out;
    }
    if (left_out == 0) return;
    element_.note(
        fmt::format("the robot's file states Coulomb friction of {}, which viscous friction leaves "
                    "out",
                    count_joints(left_out)),
        "joint_friction: coulomb counts it");
  }

  void read_joint(const std::string& name, const SceneElement& value) {
    const Joint* const joint = find_joint(value, name, robot_);
    if (joint == nullptr) return;
    if (!has_one_motion(*joint, scene_)) {
      value.error(scene_.locked.contains(name) ? "the joint is locked"
                                               : "the joint has not one degree of freedom",
                  "remove this line");
      return;
    }
    const SceneFields fields = value.fields({"damping", "friction", "width"});
    refuse_without_coulomb(fields);
    SceneFriction& own = scene_.joint_friction[name];
    own.damping = read_size(fields, "damping", false).value_or(own.damping);
    own.friction = read_size(fields, "friction", false).value_or(own.friction);
    own.width = read_size(fields, "width", true).value_or(width_);
  }

  void check() const {
    bool any = false;
    for (const Joint& joint : robot_.joints) {
      const auto found = scene_.joint_friction.find(joint.name);
      if (found == scene_.joint_friction.end()) continue;
      const SceneFriction& own = found->second;
      if (own.damping < 0 || own.friction < 0) {
        element_.error(fmt::format("the robot's file states negative damping or friction of \"{}\"",
                                   joint.name),
                       "give it under joints");
      }
      check_width(joint, own);
      any = any || own.damping > 0 || own.friction > 0;
    }
    if (any) return;
    element_.error(fmt::format("no joint has {}", coulomb_ ? "damping or friction" : "damping"),
                   "give it: joints: {joint: {damping: N m s/rad}}");
  }

  void check_width(const Joint& joint, const SceneFriction& own) const {
    if (!joint.limits || !(own.friction > 0)) return;
    const double fastest = joint.limits->velocity;
    if (!std::isfinite(fastest) || fastest <= kWidestRatio * own.width) return;
    element_.error(fmt::format("friction of \"{}\" falls off above {:.4g} times its width of {}, "
                               "below the joint's velocity limit of {}",
                               joint.name, kWidestRatio, own.width, fastest),
                   fmt::format("give a width of {:.1e} or more", fastest / 5000));
  }

  const SceneElement& element_;
  const Robot& robot_;
  Scene& scene_;
  bool knows_model_ = true;
  bool coulomb_ = false;
  double width_ = kFrictionWidth;
};

}  // namespace

void read_joint_friction(const SceneElement& element, const Robot& robot, Scene& scene) {
  FrictionReader(element, robot, scene).read();
}

void note_unused_friction(const SceneElement& top, const Robot& robot) {
  int stated = 0, not_counted = 0;
  for (const Joint& joint : robot.joints) {
    if (!states_friction(joint)) continue;
    ++(info_of(joint.type).has_one_freedom() ? stated : not_counted);
  }
  const auto note = [&](int count, const char* remedy) {
    if (count == 0) return;
    top.note(
        fmt::format("the robot's file states damping or friction of {}; no function counts them",
                    count_joints(count)),
        remedy);
  };
  note(stated,
       "joint_friction: viscous or coulomb in the scene adds them to the equations of motion");
  note(not_counted, "only joints of one degree of freedom have friction");
}

}  // namespace treeline
