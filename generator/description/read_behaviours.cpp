#include <fmt/format.h>

#include <algorithm>

#include "description/read_keys.hpp"
#include "description/read_scene_point.hpp"
#include "description/suggestions.hpp"
#include "text/identifier.hpp"

namespace treeline {
namespace {

std::vector<std::string> read_tasks(const SceneElement& element, const Scene& scene) {
  std::vector<std::string> tasks;
  for (const SceneElement& item : element.items()) {
    const auto name = item.text();
    if (!name) continue;
    if (!contains(scene.inputs.active_tasks, *name)) {
      const auto& points = scene.operational_points;
      const bool known = std::any_of(points.begin(), points.end(),
                                     [&](const ScenePoint& point) { return point.name == *name; });
      item.error(known ? fmt::format("the task of \"{}\" does not come and go", *name)
                       : fmt::format("there is no operational point \"{}\"", *name),
                 known ? "list it under inputs: active; what is not there is always done"
                       : suggest_name(*name, scene.inputs.active_tasks, "come and go"));
    } else if (contains(tasks, *name)) {
      item.error(fmt::format("\"{}\" is listed twice", *name), "list it once");
    } else {
      tasks.push_back(*name);
    }
  }
  return tasks;
}

}  // namespace

void read_behaviours(const SceneElement& element, const Scene& scene, SceneController& controller) {
  for (const auto& [name, value] : element.entries("write reach: [hand, elbow]")) {
    if (!is_identifier("behaviour_" + name)) {
      value.error(fmt::format("\"{}\" cannot be a name in emitted code", name),
                  "write letters, digits and single underscores");
      continue;
    }
    for (const SceneBehaviour& other : controller.behaviours) {
      if (in_capitals(other.name) != in_capitals(name)) continue;
      value.error(fmt::format("in capitals it is the same name as \"{}\"", other.name),
                  "give it another");
    }
    controller.behaviours.push_back({name, read_tasks(value, scene)});
  }
}

void check_behaviours(const SceneElement& top, const Scene& scene) {
  const bool behaves = !scene.controller->behaviours.empty();
  const auto& tasks = scene.inputs.active_tasks;
  if (behaves && !scene.controller->task) {
    top.error("behaviours are sets of tasks, but the controller has no law of tasks",
              "add task_impedance to laws, or remove behaviours");
  } else if (scene.controller->task && !behaves && !tasks.empty()) {
    top.error(fmt::format("the task of \"{}\" comes and goes, but the controller has no behaviour "
                          "that does it",
                          tasks.front()),
              "list behaviours, such as {all: [" + tasks.front() +
                  "], none: []}, or remove it from inputs: active");
  }
}

}  // namespace treeline
