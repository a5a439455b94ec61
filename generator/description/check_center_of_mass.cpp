#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "description/check_scene.hpp"
#include "description/robot_queries.hpp"
#include "functions/function_table.hpp"

namespace treeline {
namespace {

/// Derivatives of the motion of frames on links.
constexpr std::array kOfFrames{Function::point_velocity_derivatives,
                               Function::point_acceleration_derivatives};

struct Fault {
  std::string what;
  const char* remedy;
};

/// The first part of the scene that a centre of mass cannot be combined with; empty: none.
Fault find_fault(const Robot& robot, const Scene& scene, const std::string& name) {
  const SceneInputs& inputs = scene.inputs;
  if (!(total_mass(robot) > 0)) {
    return {"no link has mass", "give some link mass in the robot's file, or remove the point"};
  }
  if (inputs.base_parameters) {
    return {"base parameters are an argument, which do not contain its place",
            "make parameters of links an input, or remove the point"};
  }
  if (std::any_of(inputs.tools.begin(), inputs.tools.end(),
                  [&](const SceneTool& tool) { return tool.point == name; })) {
    return {"its origin is no argument", "remove it from tool under inputs"};
  }
  for (const SceneObject& object : scene.objects) {
    if (std::any_of(object.grasps.begin(), object.grasps.end(),
                    [&](const SceneGrasp& grasp) { return grasp.point == name; })) {
      return {fmt::format("it holds the object \"{}\"", object.name),
              "let a point on a link hold the object"};
    }
  }
  for (const Function function : kOfFrames) {
    if (std::count(scene.functions.begin(), scene.functions.end(), function) == 0) continue;
    return {fmt::format("{} is listed, which is of frames on links", function_name(function)),
            "remove the function; center_of_mass_jacobian and centroidal_momentum_derivatives are "
            "of the centre of mass"};
  }
  if (scene.controller && scene.controller->force) {
    return {"the controller pushes with points on links",
            "leave out the law of forces, or the point"};
  }
  if (scene.controller && !(inputs.payloads.empty() && inputs.parameters.empty())) {
    return {"the controller measures points without inertial parameters as arguments",
            "remove payload and parameters from inputs, or the controller, or the point"};
  }
  return {};
}

}  // namespace

bool check_center_of_mass(const SceneElement& top, const Robot& robot, const Scene& scene) {
  const auto& points = scene.operational_points;
  const auto center = std::find_if(points.begin(), points.end(), is_center_of_mass);
  if (center == points.end()) return true;
  const auto [what, remedy] = find_fault(robot, scene, center->name);
  if (what.empty()) return true;
  top.error(fmt::format("point \"{}\" is the centre of mass, but {}", center->name, what), remedy);
  return false;
}

}  // namespace treeline
