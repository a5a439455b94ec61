
#include <algorithm>
#include <utility>

#include "cli/find_all_meshes.hpp"
#include "description/scene_inputs.hpp"
#include "mechanism/build_mechanism.hpp"

namespace treeline {
namespace {

SceneTouch touch_of(const simulation::GroundShape& shape) {
  SceneTouch touch;
  touch.link = shape.link;
  for (const auto& point : shape.points) touch.points.push_back({point.x(), point.y(), point.z()});
  touch.radius = shape.radius;
  touch.axis = {shape.axis.x(), shape.axis.y(), shape.axis.z()};
  return touch;
}

bool has_inputs(const Scene& scene) {
  return std::any_of(kQuantities.begin(), kQuantities.end(),
                     [&](const QuantityInfo& row) { return has_input(scene, row.quantity); });
}

void refuse_ground_step(const Robot& robot, const Scene& scene, Diagnostics& diagnostics) {
  const std::pair<bool, const char*> refused[] = {
      {scene.ground_step->restitution > 0, "restitution: its blows end the approach"},
      {scene.holds_rows(), "constraints, loops and couplings"},
      {!scene.objects.empty(), "objects"},
      {has_inputs(scene), "arguments for what the robot is made of (`inputs`)"},
      {build_mechanism(robot, scene).has_mimics(),
       "joints that follow others, and rotors that turn"},
      {scene.implicit_friction,
       "friction and springs as they are at the end of a step (`implicit`)"},
      {scene.profile == Profile::misra, "the profile misra"}};
  for (const auto& [applies, what] : refused) {
    if (!applies) continue;
    diagnostics.add({Severity::error, scene.file, 0, "ground/step",
                     std::string("the generated step on the ground does not have ") + what,
                     "Leave out `step`; `simulate --ground` and Model.step need no code."});
  }
}

}  // namespace

void complete_ground_step(const RobotWithFiles& read, Scene& scene, Diagnostics& diagnostics) {
  if (!scene.ground_step) return;
  refuse_ground_step(read.robot, scene, diagnostics);
  if (const auto places = read_mesh_places({}, diagnostics)) {
    scene.touches = read_touches(read.files, *places, diagnostics);
  }
}

std::vector<SceneTouch> read_touches(const RobotFiles& files, const drive::MeshPlaces& places,
                                     Diagnostics& diagnostics) {
  std::vector<SceneTouch> touches;
  for (const auto& shape : read_ground_shapes(files, places, diagnostics)) {
    touches.push_back(touch_of(shape));
  }
  return touches;
}

}  // namespace treeline
