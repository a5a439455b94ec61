
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "description/follow_target.hpp"
#include "description/noise.hpp"
#include "description/read_keys.hpp"
#include "description/read_scene_point.hpp"
#include "description/scene_words.hpp"
#include "description/snap_angles.hpp"
#include "description/suggestions.hpp"
#include "functions/function.hpp"
#include "text/identifier.hpp"

namespace treeline {
namespace {

void read_name(const SceneElement& element, Scene& scene) {
  const auto name = element.text();
  if (!name) return;
  if (!is_package_name(*name)) {
    element.error(
        fmt::format("\"{}\" cannot be the name of emitted code and of a target in CMake", *name),
        fmt::format("write {}", package_name_from(*name)));
  }
  scene.name = *name;
}

void read_functions(const SceneElement& element, Scene& scene) {
  if (element.is("all")) {
    element.error("a list is expected here, not \"all\"", suggest_function("all"));
    return;
  }
  const std::vector<SceneElement> items = element.items();
  const std::size_t known = kSceneFunctions.size();
  if (items.size() > 2 * known) {
    element.error(fmt::format("{} functions are listed, but there are {}", items.size(), known),
                  "list each once");
    return;
  }
  for (const SceneElement& item : items) {
    const auto name = item.text();
    if (!name) continue;
    const auto function = find_function(*name);
    if (!function) {
      item.error(fmt::format("there is no function \"{}\"", *name), suggest_function(*name));
      continue;
    }
    const bool repeated = std::count(scene.functions.begin(), scene.functions.end(), *function) > 0;
    if (repeated) item.error(fmt::format("{} is listed twice", *name), "list it once");
    scene.functions.push_back(*function);
  }
  std::sort(scene.functions.begin(), scene.functions.end());
}

std::optional<double> read_mass_limit(const SceneElement& element, const SceneFields& fields,
                                      const char* key) {
  const auto found = fields.find(key);
  if (found == fields.end()) {
    element.error(fmt::format("the key \"{}\" is missing", key),
                  "give mass (kg) and inertia (kg m^2) from which on a direction yields");
    return std::nullopt;
  }
  const auto value = found->second.number();
  if (value && !(*value > 0)) {
    found->second.error("this is not positive", "a direction that feels heavier than this yields");
  }
  return value;
}

void read_damped(const SceneElement& element, Scene& scene) {
  const auto fields = element.fields({"mass", "inertia"});
  const auto mass = read_mass_limit(element, fields, "mass");
  const auto inertia = read_mass_limit(element, fields, "inertia");
  if (mass && inertia) scene.damped = EffectiveMassLimit{*mass, *inertia};
}

void read_snap(const SceneElement& element, Scene& scene) {
  const auto tolerance = element.number();
  if (!tolerance) return;
  if (*tolerance < 0 || *tolerance > kWidestSnap) {
    element.error(fmt::format("{} is not between 0 and {} rad", *tolerance, kWidestSnap),
                  "angles that are farther off are no rounded quarter turns; correct the file");
    return;
  }
  scene.snap_angles = *tolerance;
}

void read_noise(const SceneElement& element, Scene& scene) {
  if (element.is("keep")) {
    scene.noise = 0;
    return;
  }
  const auto limit = element.number();
  if (!limit) return;
  if (*limit < kResolution || *limit > kMostNoise) {
    element.error(fmt::format("{} is not between {:.1e} and {}", *limit, kResolution, kMostNoise),
                  "write `keep` for every number as it is in the files");
    return;
  }
  scene.noise = *limit;
}

template <class Value>
void take_word(const SceneElement& element, Value& value) {
  if (const auto chosen = element.choice(words_of<Value>())) value = static_cast<Value>(*chosen);
}

void read_base(const SceneElement& element, Scene& scene) {
  take_word(element, scene.base);
}

void read_gravity(const SceneElement& element, Scene& scene) {
  scene.gravity = element.three_numbers().value_or(scene.gravity);
}

void note_other_gravity(const SceneElement& top, const Robot& robot) {
  const auto& stated = robot.hints.gravity;
  if (!stated || *stated == Scene{}.gravity) return;
  top.note(
      fmt::format("the robot's file has gravity [{}], the scene says nothing and has [0, 0, -9.81]",
                  fmt::join(*stated, ", ")),
      "write gravity in the scene");
}

void read_real(const SceneElement& element, Scene& scene) {
  take_word(element, scene.real);
}

void read_sin_cos(const SceneElement& element, Scene& scene) {
  take_word(element, scene.sin_cos);
}

void read_accuracy(const SceneElement& element, Scene& scene) {
  take_word(element, scene.accuracy);
}

void read_lanes(const SceneElement& element, Scene& scene) {
  scene.lanes = 1 << element.choice({"1", "2", "4", "8"}).value_or(3);
  scene.asks_for_lanes = true;
}

void read_language(const SceneElement& element, Scene& scene) {
  take_word(element, scene.language);
}

void read_profile(const SceneElement& element, Scene& scene) {
  take_word(element, scene.profile);
}

void read_optimize(const SceneElement& element, Scene& scene) {
  take_word(element, scene.optimize);
}

void read_selftest(const SceneElement& element, Scene& scene) {
  scene.selftest = 1 << element.choice({"1", "2", "4", "8"}).value_or(1);
}

void read_target(const SceneElement& element, Scene& scene) {
  const std::vector<std::string> names = target_names();
  scene.target = names[element.choice(names).value_or(0)];
}

void read_batch(const SceneElement& element, Scene& scene) {
  scene.batch = 2 << element.choice({"2", "4", "8", "16"}).value_or(2);
}

void read_singular(const SceneElement& element, Scene& scene) {
  take_word(element, scene.singular);
}

/// A reader of a key whose meaning does not depend on the robot.
template <void (*read)(const SceneElement&, Scene&)>
void without_robot(const SceneElement& element, const Robot&, Scene& scene) {
  read(element, scene);
}

/// A reader of a list of points.
template <std::vector<ScenePoint> (*read)(const SceneElement&, const Robot&),
          std::vector<ScenePoint> Scene::*points>
void read_points(const SceneElement& element, const Robot& robot, Scene& scene) {
  scene.*points = read(element, robot);
}

}  // namespace

const std::vector<SceneKey>& scene_keys() {
  static const std::vector<SceneKey> keys = {
      {"name", without_robot<read_name>},
      {"base", without_robot<read_base>},
      {"gravity", without_robot<read_gravity>, note_other_gravity},
      {"real", without_robot<read_real>},
      {"sin_cos", without_robot<read_sin_cos>},
      {"accuracy", without_robot<read_accuracy>},
      {"snap_angles", without_robot<read_snap>},
      {"noise", without_robot<read_noise>},
      {"lanes", without_robot<read_lanes>},
      {"language", without_robot<read_language>},
      {"profile", without_robot<read_profile>},
      {"optimize", without_robot<read_optimize>},
      {"selftest", without_robot<read_selftest>},
      {"target", without_robot<read_target>},
      {"batch", without_robot<read_batch>},
      {"singular", without_robot<read_singular>},
      {"damped", without_robot<read_damped>},
      {"functions", without_robot<read_functions>},
      {"operational_points", read_points<read_operational_points, &Scene::operational_points>},
      {"external_forces", read_points<read_external_forces, &Scene::external_forces>},
      {"contacts", read_points<read_contacts, &Scene::contacts>},
      {"constraints", read_constraints},
      {"objects", without_robot<read_objects>},
      {"locked", read_locked},
      {"inputs", read_scene_inputs},
      {"couplings", read_couplings},
      {"regressor", read_regressor},
      {"passive", read_passive},
      {"torque_limits", read_torque_limits},
      {"controller", read_controller},
      {"armature", read_armature, note_unused_rotors},
      {"joint_friction", read_joint_friction, note_unused_friction},
      {"joint_springs", read_joint_springs, note_unused_springs},
      {"robots"},
      {"ground"},
      {"obstacles"},
      {"avoidance"},
  };
  return keys;
}

}  // namespace treeline
