#include <fmt/format.h>

#include <algorithm>

#include "description/inertias.hpp"
#include "description/read_keys.hpp"
#include "description/read_scene_point.hpp"
#include "text/identifier.hpp"
#include "text/suggest_name.hpp"

namespace treeline {
namespace {

/// The value of a key that must be there.
const SceneElement* find_required(const SceneElement& element, const SceneFields& fields,
                                  const char* key, const char* remedy) {
  const auto found = fields.find(key);
  if (found != fields.end()) return &found->second;
  element.error(fmt::format("the key \"{}\" is missing", key), remedy);
  return nullptr;
}

/// False when one of them is missing.
bool read_moments(const SceneElement& element, Inertial& inertial) {
  const std::vector<std::pair<std::string, double*>> entries = {
      {"ixx", &inertial.ixx}, {"iyy", &inertial.iyy}, {"izz", &inertial.izz},
      {"ixy", &inertial.ixy}, {"ixz", &inertial.ixz}, {"iyz", &inertial.iyz}};
  std::vector<std::string> keys;
  for (const auto& [key, entry] : entries) keys.push_back(key);
  const SceneFields fields = element.fields(keys);
  bool complete = true;
  for (const auto& [key, entry] : entries) {
    const auto found = fields.find(key);
    if (found != fields.end()) {
      *entry = found->second.number().value_or(0);
    } else if (key[1] == key[2]) {
      element.error(fmt::format("the key \"{}\" is missing", key),
                    "give ixx, iyy and izz; products that are left out are 0");
      complete = false;
    }
  }
  return complete;
}

void read_inertial(const SceneElement& element, const SceneFields& fields, Inertial& inertial) {
  inertial.mass = 1;  // so that a missing one is reported once
  if (const auto* mass = find_required(element, fields, "mass", "give the mass in kg")) {
    const double value = mass->number().value_or(1);
    if (value > 0) {
      inertial.mass = value;
    } else {
      mass->error("the mass is not positive",
                  "give the mass in kg; an object without mass is constraints between its hands");
    }
  }
  if (const auto center = fields.find("center"); center != fields.end()) {
    inertial.origin.xyz = center->second.three_numbers().value_or(inertial.origin.xyz);
  }
  const char* remedy = "give {ixx: , iyy: , izz: , ixy: , ixz: , iyz: } about the centre of mass";
  const auto* inertia = find_required(element, fields, "inertia", remedy);
  if (inertia == nullptr || !read_moments(*inertia, inertial)) return;
  if (const auto fault = find_unphysical(inertial)) {
    inertia->error(*fault, "check the units (kg m^2, about the centre of mass) and the signs");
  } else if (!(principal_moments(inertial)[0] > 0)) {
    inertia->error("the object has no inertia about some axis",
                   "give every axis some: the equations of motion divide by it");
  }
}

SceneGrasp read_grasp(const SceneElement& element, const Scene& scene) {
  SceneGrasp grasp;
  const SceneFields fields = element.fields({"point", "origin"});
  if (const auto origin = fields.find("origin"); origin != fields.end()) {
    grasp.origin = read_origin(origin->second);
  }
  const auto* point =
      find_required(element, fields, "point", "name the operational point that holds the object");
  const auto name = point != nullptr ? point->text() : std::nullopt;
  if (!name) return grasp;
  grasp.point = *name;
  std::vector<std::string> names;
  for (const ScenePoint& known : scene.operational_points) names.push_back(known.name);
  if (std::find(names.begin(), names.end(), *name) == names.end()) {
    point->error(fmt::format("there is no operational point \"{}\"", *name),
                 suggest_name(*name, names, "the operational points are"));
  }
  return grasp;
}

bool holds(const SceneObject& object, const std::string& point) {
  return std::any_of(object.grasps.begin(), object.grasps.end(),
                     [&](const SceneGrasp& grasp) { return grasp.point == point; });
}

void read_grasps(const SceneElement& element, const Scene& scene, SceneObject& object) {
  const std::vector<SceneElement> items = element.items();
  if (items.empty()) {
    element.error("no grasp is listed", "list the operational points that hold the object");
  }
  for (const SceneElement& item : items) {
    const SceneGrasp grasp = read_grasp(item, scene);
    const bool taken = std::any_of(scene.objects.begin(), scene.objects.end(),
                                   [&](const auto& other) { return holds(other, grasp.point); });
    if (!grasp.point.empty() && (taken || holds(object, grasp.point))) {
      item.error(fmt::format("the point \"{}\" holds an object already", grasp.point),
                 "let each point hold one object, once");
    }
    object.grasps.push_back(grasp);
  }
}

SceneObject read_object(const SceneElement& element, const Scene& scene) {
  SceneObject object;
  const SceneFields fields =
      element.fields({"name", "mass", "center", "inertia", "grasps", "shapes"});
  if (const auto* name = find_required(element, fields, "name", "give the object a name")) {
    object.name = name->text().value_or("");
    if (!object.name.empty() && !is_identifier(object.name)) {
      name->error(fmt::format("\"{}\" cannot be a name in emitted code", object.name),
                  fmt::format("write {}", identifier_from(object.name)));
    }
  }
  read_inertial(element, fields, object.inertial);
  const auto* grasps = find_required(element, fields, "grasps", "list who holds the object");
  if (grasps != nullptr) read_grasps(*grasps, scene, object);
  return object;
}

}  // namespace

void read_objects(const SceneElement& element, Scene& scene) {
  for (const SceneElement& item : element.items()) {
    SceneObject object = read_object(item, scene);
    const auto same_name = [&](const SceneObject& other) { return other.name == object.name; };
    if (!object.name.empty() &&
        std::any_of(scene.objects.begin(), scene.objects.end(), same_name)) {
      item.error(fmt::format("the name \"{}\" is already taken in this list", object.name),
                 "give each a name of its own");
    }
    scene.objects.push_back(std::move(object));
  }
}

}  // namespace treeline
