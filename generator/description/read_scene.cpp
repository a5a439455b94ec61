#include "description/read_scene.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "description/check_scene.hpp"
#include "description/find_function.hpp"
#include "description/identifier.hpp"
#include "description/parse_yaml.hpp"
#include "description/read_scene_object.hpp"
#include "description/read_scene_point.hpp"
#include "description/read_text_file.hpp"
#include "description/scene_element.hpp"
#include "description/snap_angles.hpp"

namespace treeline {
namespace {

void read_name(const SceneElement& element, Scene& scene) {
  const auto name = element.text();
  if (!name) return;
  if (!is_identifier(*name)) {
    element.error(fmt::format("\"{}\" cannot be the name of a namespace in C++", *name),
                  fmt::format("write {}", identifier_from(*name)));
  }
  scene.name = *name;
}

void read_functions(const SceneElement& element, Scene& scene) {
  std::vector<std::string> names;
  const std::vector<Function> known = every_function();
  for (const Function function : known) names.emplace_back(function_name(function));
  const std::vector<SceneElement> items = element.items();
  if (items.empty())
    element.error("no function is listed", "list some, or leave out the key for all");
  for (const SceneElement& item : items) {
    const auto index = item.choice(names);
    if (!index) continue;
    const Function function = known[*index];
    const bool repeated = std::count(scene.functions.begin(), scene.functions.end(), function) > 0;
    if (repeated) item.error(fmt::format("{} is listed twice", names[*index]), "list it once");
    scene.functions.push_back(function);
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
  if (const auto lanes = find("lanes"); lanes != fields.end()) {
    scene.lanes = 1 << lanes->second.choice({"1", "2", "4", "8"}).value_or(3);
  }
  if (const auto batch = find("batch"); batch != fields.end()) {
    scene.batch = 2 << batch->second.choice({"2", "4", "8", "16"}).value_or(2);
  }
  if (const auto damped = find("damped"); damped != fields.end()) {
    read_damped(damped->second, scene);
  }
  if (const auto functions = find("functions"); functions != fields.end()) {
    read_functions(functions->second, scene);
  }
}

Scene read_fields(const SceneElement& top, const Robot& robot) {
  Scene scene;
  scene.name = identifier_from(robot.name);
  const auto fields = top.fields({"name", "base", "gravity", "real", "sin_cos", "accuracy", "lanes",
                                  "batch", "damped", "operational_points", "external_forces",
                                  "contacts", "functions", "locked", "objects", "snap_angles"});
  read_settings(fields, scene);
  if (const auto points = fields.find("operational_points"); points != fields.end()) {
    scene.operational_points = read_operational_points(points->second, robot);
  }
  if (const auto forces = fields.find("external_forces"); forces != fields.end()) {
    scene.external_forces = read_external_forces(forces->second, robot);
  }
  if (const auto contacts = fields.find("contacts"); contacts != fields.end()) {
    scene.contacts = read_contacts(contacts->second, robot);
  }
  if (const auto objects = fields.find("objects"); objects != fields.end()) {
    read_objects(objects->second, scene);
  }
  if (const auto locked = fields.find("locked"); locked != fields.end()) {
    read_locked(locked->second, robot, scene);
  }
  return scene;
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
  snap_angles(robot, scene, diagnostics);
  return scene;
}

std::optional<Scene> read_scene(const std::string& path, const Robot& robot,
                                Diagnostics& diagnostics, const std::vector<Function>& functions) {
  const auto text = read_text_file(path, diagnostics);
  if (!text) return std::nullopt;
  return parse_scene(*text, path, robot, diagnostics, functions);
}

}  // namespace treeline
