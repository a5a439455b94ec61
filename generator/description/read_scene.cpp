#include "description/read_scene.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "description/check_scene.hpp"
#include "description/default_base.hpp"
#include "description/follow_target.hpp"
#include "description/identifier.hpp"
#include "description/noise.hpp"
#include "description/parse_yaml.hpp"
#include "description/read_armature.hpp"
#include "description/read_constraints.hpp"
#include "description/read_controller.hpp"
#include "description/read_joint_friction.hpp"
#include "description/read_joint_springs.hpp"
#include "description/read_regressor.hpp"
#include "description/read_scene_inputs.hpp"
#include "description/read_scene_object.hpp"
#include "description/read_scene_point.hpp"
#include "description/read_surroundings.hpp"
#include "description/read_text_file.hpp"
#include "description/read_torque_limits.hpp"
#include "description/scene_element.hpp"
#include "description/snap_angles.hpp"
#include "description/suggest_function.hpp"
#include "functions/find_function.hpp"

namespace treeline {
namespace {

void read_name(const SceneElement& element, Scene& scene) {
  const auto name = element.text();
  if (!name) return;
  if (!is_package_name(*name)) {
    element.error(
        fmt::format("\"{}\" cannot be the name of a namespace in C++ and of a target in CMake",
                    *name),
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
  if (items.empty())
    element.error("no function is listed", "list some, or leave out the key for all");
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

std::optional<double> read_heaviest(const SceneElement& element,
                                    const std::map<std::string, SceneElement>& fields,
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
  const auto mass = read_heaviest(element, fields, "mass");
  const auto inertia = read_heaviest(element, fields, "inertia");
  if (mass && inertia) scene.damped = HeaviestMotion{*mass, *inertia};
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

void read_settings(const std::map<std::string, SceneElement>& fields, Scene& scene) {
  const auto find = [&](const char* key) { return fields.find(key); };
  if (const auto name = find("name"); name != fields.end()) read_name(name->second, scene);
  if (const auto base = find("base"); base != fields.end()) {
    scene.base = base->second.choice({"fixed", "floating"}) == 1 ? Base::floating : Base::fixed;
  }
  if (const auto gravity = find("gravity"); gravity != fields.end()) {
    scene.gravity = gravity->second.three_numbers().value_or(scene.gravity);
  }
  if (const auto real = find("real"); real != fields.end()) {
    scene.real = real->second.choice({"float", "double"}) == 0 ? Real::float32 : Real::float64;
  }
  if (const auto sin_cos = find("sin_cos"); sin_cos != fields.end()) {
    scene.sin_cos =
        sin_cos->second.choice({"computed", "given"}) == 1 ? Sines::given : Sines::computed;
  }
  if (const auto accuracy = find("accuracy"); accuracy != fields.end()) {
    scene.accuracy =
        static_cast<Accuracy>(accuracy->second.choice({"best", "balanced", "fastest"}).value_or(1));
  }
  if (const auto snap = find("snap_angles"); snap != fields.end()) read_snap(snap->second, scene);
  if (const auto noise = find("noise"); noise != fields.end()) read_noise(noise->second, scene);
  if (const auto lanes = find("lanes"); lanes != fields.end()) {
    scene.lanes = 1 << lanes->second.choice({"1", "2", "4", "8"}).value_or(3);
    scene.asks_for_lanes = true;
  }
  if (const auto language = find("language"); language != fields.end()) {
    const bool is_c = language->second.choice({"c++", "c"}) == 1;
    scene.language = is_c ? Language::c : Language::cpp;
  }
  if (const auto target = find("target"); target != fields.end()) {
    const std::vector<std::string> names = target_names();
    scene.target = names[target->second.choice(names).value_or(0)];
  }
  if (const auto batch = find("batch"); batch != fields.end()) {
    scene.batch = 2 << batch->second.choice({"2", "4", "8", "16"}).value_or(2);
  }
  if (const auto singular = find("singular"); singular != fields.end()) {
    scene.singular = singular->second.choice({"smooth", "exact"}) == 1 ? SingularTasks::exact
                                                                       : SingularTasks::smooth;
  }
  if (const auto damped = find("damped"); damped != fields.end()) {
    read_damped(damped->second, scene);
  }
  if (const auto functions = find("functions"); functions != fields.end()) {
    read_functions(functions->second, scene);
  }
}

/// Robots that the scene lists itself have been read before it, see `read_robots`.
void check_robots(const std::map<std::string, SceneElement>& fields, const Robot& robot) {
  const auto list = fields.find("robots");
  if (list == fields.end()) return;
  if (robot.parts.empty()) {
    list->second.error("this scene lists its robots itself, but a URDF is given beside it",
                       "name the scene alone: treeline generate scene.yaml");
  } else if (const auto base = fields.find("base"); base != fields.end()) {
    base->second.error("each robot has a base of its own", "write base into the list robots");
  }
}

Scene read_fields(const SceneElement& top, const Robot& robot) {
  Scene scene;
  scene.name = package_name_from(robot.name);
  const auto fields = top.fields({"name",
                                  "base",
                                  "gravity",
                                  "real",
                                  "sin_cos",
                                  "accuracy",
                                  "lanes",
                                  "batch",
                                  "damped",
                                  "operational_points",
                                  "external_forces",
                                  "contacts",
                                  "controller",
                                  "constraints",
                                  "couplings",
                                  "functions",
                                  "inputs",
                                  "armature",
                                  "joint_friction",
                                  "joint_springs",
                                  "language",
                                  "locked",
                                  "objects",
                                  "obstacles",
                                  "avoidance",
                                  "passive",
                                  "regressor",
                                  "robots",
                                  "singular",
                                  "snap_angles",
                                  "noise",
                                  "target",
                                  "torque_limits"});
  check_robots(fields, robot);
  if (!fields.contains("base") && robot.parts.empty()) scene.base = default_base(robot);
  read_settings(fields, scene);
  follow_target(scene);
  if (const auto points = fields.find("operational_points"); points != fields.end()) {
    scene.operational_points = read_operational_points(points->second, robot);
  }
  if (const auto forces = fields.find("external_forces"); forces != fields.end()) {
    scene.external_forces = read_external_forces(forces->second, robot);
  }
  if (const auto contacts = fields.find("contacts"); contacts != fields.end()) {
    scene.contacts = read_contacts(contacts->second, robot);
  }
  add_loops_of_robot(robot, scene);
  if (const auto constraints = fields.find("constraints"); constraints != fields.end()) {
    read_constraints(constraints->second, robot, scene);
  }
  if (const auto objects = fields.find("objects"); objects != fields.end()) {
    read_objects(objects->second, scene);
  }
  if (const auto locked = fields.find("locked"); locked != fields.end()) {
    read_locked(locked->second, robot, scene);
  }
  if (const auto inputs = fields.find("inputs"); inputs != fields.end()) {
    read_scene_inputs(inputs->second, robot, scene);
  }
  if (const auto couplings = fields.find("couplings"); couplings != fields.end()) {
    read_couplings(couplings->second, robot, scene);
  }
  if (const auto regressor = fields.find("regressor"); regressor != fields.end()) {
    read_regressor(regressor->second, robot, scene);
  }
  if (const auto passive = fields.find("passive"); passive != fields.end()) {
    read_passive(passive->second, robot, scene);
  }
  if (const auto limits = fields.find("torque_limits"); limits != fields.end()) {
    read_torque_limits(limits->second, robot, scene);
  }
  if (const auto controller = fields.find("controller"); controller != fields.end()) {
    read_controller(controller->second, robot, scene);
  }
  if (const auto armature = fields.find("armature"); armature != fields.end()) {
    read_armature(armature->second, robot, scene);
  } else {
    note_unused_rotors(top, robot);
  }
  if (const auto friction = fields.find("joint_friction"); friction != fields.end()) {
    read_joint_friction(friction->second, robot, scene);
  } else {
    note_unused_friction(top, robot);
  }
  if (const auto springs = fields.find("joint_springs"); springs != fields.end()) {
    read_joint_springs(springs->second, robot, scene);
  }
  (void)read_surroundings(fields, robot);  // for faults: what is generated does not depend on it
  return scene;
}

void note_missing_scene(const Robot& robot, const Scene& scene, Diagnostics& diagnostics) {
  const char* const base =
      scene.base == Base::floating ? "the base floats, for no joint moves" : "the base is fixed";
  diagnostics.add({Severity::note, robot.file, 0, "",
                   fmt::format("there is no scene: functions of the joints alone, and {}", base),
                   "`treeline init-scene` writes a scene to start from"});
}

}  // namespace

std::optional<Scene> parse_scene(const std::string& text, const std::string& file_name,
                                 const Robot& robot, Diagnostics& diagnostics,
                                 const std::vector<Function>& functions) {
  const auto document = parse_yaml(text, file_name, diagnostics);
  if (!document) return std::nullopt;
  SceneReading reading{file_name, diagnostics};
  const SceneElement top(*document, "", reading);
  Scene scene = read_fields(top, robot);
  scene.file = file_name;
  if (!functions.empty()) scene.functions = functions;
  if (!reading.failed) complete_scene(top, robot, scene);
  if (reading.failed) return std::nullopt;
  if (!file_name.empty() && scene.base == Base::floating && !(*document)["base"]) {
    top.note("the scene says nothing of the base, which floats, for no joint moves",
             "write base: floating or base: fixed to choose");
  }
  if (!robot.loops.empty()) {
    diagnostics.add(
        {Severity::note, robot.file, 0, "",
         fmt::format("{} loops are closed by functions about constraints; to all others "
                     "the robot is the open tree",
                     robot.loops.size()),
         "use constrained_forward_dynamics and supported_control_torque"});
  }
  snap_angles(robot, scene, diagnostics);
  if (scene.noise <= kResolution) return scene;
  NoiseDecisions decisions;
  scene = without_noise(std::move(scene), noise_limits(robot, scene), &decisions);
  scene.taken_exact = std::move(decisions);
  return scene;
}

std::optional<Scene> read_scene(const std::string& path, const Robot& robot,
                                Diagnostics& diagnostics, const std::vector<Function>& functions) {
  const auto text = path.empty() ? std::string() : read_text_file(path, diagnostics);
  if (!text) return std::nullopt;
  auto scene = parse_scene(*text, shown_path(path), robot, diagnostics, functions);
  if (scene && path.empty()) note_missing_scene(robot, *scene, diagnostics);
  return scene;
}

}  // namespace treeline
