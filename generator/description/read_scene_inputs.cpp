#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "description/read_keys.hpp"
#include "description/read_scene_point.hpp"
#include "description/robot_queries.hpp"
#include "description/scene_inputs.hpp"
#include "description/scene_queries.hpp"
#include "text/suggest_name.hpp"

namespace treeline {
namespace {

double read_positive(const SceneFields& fields, const char* key, double otherwise) {
  const auto found = fields.find(key);
  if (found == fields.end()) return otherwise;
  const double value = found->second.number().value_or(otherwise);
  if (value > 0) return value;
  found->second.error(fmt::format("{} is not positive", value),
                      "give the largest that occurs; rounding bounds hold up to it");
  return otherwise;
}

/// The name alone, or the value of `key` in a map.
std::optional<std::string> read_name(const SceneElement& element, const SceneFields& fields,
                                     const char* key) {
  if (!element.is_map()) return element.text();
  const auto found = fields.find(key);
  if (found != fields.end()) return found->second.text();
  element.error(fmt::format("the key \"{}\" is missing", key), "name it");
  return std::nullopt;
}

/// Ranges of a body that has the parameters of a link: twice the values of the file.
SceneInertia ranges_of(const Link& link) {
  SceneInertia ranges{link.name};
  if (!link.inertial || !(link.inertial->mass > 0)) return ranges;
  const Inertial& own = *link.inertial;
  const auto& c = own.origin.xyz;
  const double trace = std::abs(own.ixx) + std::abs(own.iyy) + std::abs(own.izz);
  ranges.mass = 2 * own.mass;
  ranges.reach = 2 * (std::hypot(c[0], c[1], c[2]) + std::sqrt(trace / 2 / own.mass));
  return ranges;
}

/// The links of `payload` or `parameters`.
std::vector<SceneInertia> read_inertias(const SceneElement& element, const Robot& robot,
                                        const Scene& scene, bool of_links) {
  std::vector<SceneInertia> inertias;
  for (const SceneElement& item : one_or_more(element)) {
    const SceneFields fields =
        item.is_map() ? item.fields({"link", "mass", "reach"}) : SceneFields{};
    const auto name = read_name(item, fields, "link");
    const Link* link = name ? find_moving_link(item, *name, robot, scene) : nullptr;
    if (link == nullptr) continue;
    if (std::any_of(inertias.begin(), inertias.end(),
                    [&](const SceneInertia& other) { return other.link == *name; })) {
      item.error(fmt::format("the link \"{}\" is listed twice", *name), "list it once");
      continue;
    }
    SceneInertia inertia = of_links ? ranges_of(*link) : SceneInertia{*name};
    inertia.mass = read_positive(fields, "mass", inertia.mass);
    inertia.reach = read_positive(fields, "reach", inertia.reach);
    inertias.push_back(inertia);
  }
  return inertias;
}

bool holds_object(const Scene& scene, const std::string& point) {
  return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const SceneObject& object) {
    return std::any_of(object.grasps.begin(), object.grasps.end(),
                       [&](const SceneGrasp& grasp) { return grasp.point == point; });
  });
}

/// Points of one kind whose places may be arguments.
struct Places {
  const char* key;                        ///< in maps of `inputs`
  const char* kind;                       ///< as messages say it
  const char* list;                       ///< key of the scene's list
  const std::vector<ScenePoint>& points;  ///< those of the scene
  std::vector<std::string> keys;          ///< known in maps
};

/// False, and an error, for a name that no place of an argument can have.
bool check_place(const SceneElement& item, const std::string& name, const Places& places,
                 const std::vector<SceneTool>& before, const Scene& scene) {
  std::vector<std::string> names;
  for (const ScenePoint& point : places.points) names.push_back(point.name);
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    item.error(fmt::format("there is no {} \"{}\"", places.kind, name),
               names.empty() ? fmt::format("add a list {}", places.list)
                             : suggest_name(name, names, fmt::format("the {}s are", places.kind)));
  } else if (&places.points == &scene.operational_points && holds_object(scene, name)) {
    item.error(fmt::format("the point \"{}\" holds an object", name),
               "name a point that holds none, or remove the object");
  } else if (std::any_of(before.begin(), before.end(),
                         [&](const SceneTool& other) { return other.point == name; })) {
    item.error(fmt::format("the {} \"{}\" is listed twice", places.key, name), "list it once");
  } else {
    return true;
  }
  return false;
}

std::vector<SceneTool> read_places(const SceneElement& element, const Places& places,
                                   const Scene& scene) {
  std::vector<SceneTool> read;
  for (const SceneElement& item : one_or_more(element)) {
    const SceneFields fields = item.is_map() ? item.fields(places.keys) : SceneFields{};
    const auto name = read_name(item, fields, places.key);
    if (!name || !check_place(item, *name, places, read, scene)) continue;
    SceneTool tool{*name};
    tool.reach = read_positive(fields, "reach", tool.reach);
    if (const auto found = fields.find("orientation"); found != fields.end()) {
      tool.orientation = found->second.choice({"false", "true"}) == 1;
    }
    read.push_back(tool);
  }
  return read;
}

/// Names of constraints, and of operational points whose tasks, come and go.
void read_active(const SceneElement& element, Scene& scene) {
  std::vector<std::string> held, tasks;
  for (const ScenePoint& point : scene.constraints) held.push_back(point.name);
  for (const SceneLoop& loop : scene.loops) held.push_back(loop.first.name);
  for (const ScenePoint& point : scene.operational_points) tasks.push_back(point.name);
  std::vector<std::string> known = held;
  known.insert(known.end(), tasks.begin(), tasks.end());
  for (const SceneElement& item : one_or_more(element)) {
    const auto name = item.text();
    if (!name) continue;
    auto& read = contains(held, *name) ? scene.inputs.active : scene.inputs.active_tasks;
    if (!contains(known, *name)) {
      item.error(fmt::format("there is no constraint or operational point \"{}\"", *name),
                 known.empty() ? "add a list constraints or operational_points"
                               : suggest_name(*name, known, "there are"));
    } else if (contains(held, *name) && contains(tasks, *name)) {
      item.error(fmt::format("both a constraint and an operational point are \"{}\"", *name),
                 "give one another name");
    } else if (contains(read, *name)) {
      item.error(fmt::format("\"{}\" is listed twice", *name), "list it once");
    } else {
      read.push_back(*name);
    }
  }
}

/// `[gravity, base_parameters]`, for what is an input as a whole.
void read_names_of_inputs(const SceneElement& element, SceneInputs& inputs) {
  for (const SceneElement& item : element.items()) {
    const auto name = item.choice({"gravity", "base_parameters"});
    if (!name) continue;
    bool& listed = *name == 0 ? inputs.gravity : inputs.base_parameters;
    if (listed) item.error("this input is listed twice", "list it once");
    listed = true;
  }
}

}  // namespace

void read_scene_inputs(const SceneElement& element, const Robot& robot, Scene& scene) {
  if (element.is_list()) return read_names_of_inputs(element, scene.inputs);
  const SceneFields fields = element.fields(
      {"gravity", "payload", "parameters", "base_parameters", "tool", "contact", "active"});
  if (const auto gravity = fields.find("gravity"); gravity != fields.end()) {
    scene.inputs.gravity = gravity->second.choice({"false", "true"}) == 1;
  }
  if (const auto payload = fields.find("payload"); payload != fields.end()) {
    scene.inputs.payloads = read_inertias(payload->second, robot, scene, false);
  }
  if (const auto links = fields.find("parameters"); links != fields.end()) {
    scene.inputs.parameters = read_inertias(links->second, robot, scene, true);
  }
  if (const auto base = fields.find("base_parameters"); base != fields.end()) {
    scene.inputs.base_parameters = base->second.choice({"false", "true"}) == 1;
    if (scene.inputs.base_parameters && fields.contains("parameters")) {
      base->second.error("base parameters stand in place of the parameters of all links",
                         "leave out parameters, or write base_parameters: false");
    }
  }
  if (const auto tool = fields.find("tool"); tool != fields.end()) {
    const Places places{"point",
                        "operational point",
                        "operational_points",
                        scene.operational_points,
                        {"point", "reach", "orientation"}};
    scene.inputs.tools = read_places(tool->second, places, scene);
  }
  if (const auto contact = fields.find("contact"); contact != fields.end()) {
    const Places places{"contact", "contact", "contacts", scene.contacts, {"contact", "reach"}};
    scene.inputs.contacts = read_places(contact->second, places, scene);
  }
  if (const auto active = fields.find("active"); active != fields.end()) {
    read_active(active->second, scene);
  }
}

void check_inputs_used(const SceneElement& top, const Scene& scene) {
  std::vector<Function> functions = list_controller_functions(scene);
  functions.insert(functions.end(), scene.functions.begin(), scene.functions.end());
  for (const QuantityInfo& row : kQuantities) {
    if (!is_of_model(row.quantity) || !has_input(scene, row.quantity)) continue;
    const bool used = std::any_of(functions.begin(), functions.end(), [&](Function f) {
      const bool refused =
          row.quantity == Quantity::base_parameters && depends_on_inertia(scene, f);
      return refused || takes_input(scene, f, row.quantity);
    });
    if (used) continue;
    top.warn(fmt::format("{} is listed under inputs, but no function depends on it", row.symbol),
             "remove it, or add a function that does");
  }
}

}  // namespace treeline
