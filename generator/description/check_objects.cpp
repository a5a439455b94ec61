#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "description/check_scene.hpp"
#include "description/rotation.hpp"
#include "description/scene_queries.hpp"

namespace treeline {
namespace {

/// Below this, of lengths and of sines, grasps are taken for one, or for three on a line.
constexpr double kFlat = 1e-6;

std::string link_of(const Scene& scene, const std::string& point) {
  for (const ScenePoint& known : scene.operational_points) {
    if (known.name == point) return known.link;
  }
  return {};
}

/// Rows that nothing moves: an error where a bare solve is asked for or nothing moves at all, else
/// they yield.
void complain(const SceneElement& top, bool must_end, const std::string& what,
              const std::string& remedy) {
  if (must_end) {
    top.error(what, remedy);
  } else {
    top.warn(what, remedy + ", or take what hands cannot do as rows that yield");
  }
}

/// Table 7.1 inverts Lambda^-1 over six rows of every grasp.
void check_freedoms(const SceneElement& top, const Robot& robot, const Scene& scene) {
  const bool exact = scene.singular == SingularTasks::exact;
  Freedoms all;
  int rows = 0;
  for (const SceneObject& object : scene.objects) {
    for (const SceneGrasp& grasp : object.grasps) {
      const Freedoms own = find_freedoms_of_link(robot, scene, link_of(scene, grasp.point));
      if (count(own) < 6) {
        complain(top, exact || count(own) == 0,
                 fmt::format("object \"{}\" needs six coordinates at point \"{}\", which has {}",
                             object.name, grasp.point, count(own)),
                 "let points hold it that can move it in every direction");
      }
      all.insert(own.begin(), own.end());
      rows += 6;
    }
  }
  if (rows > count(all)) {
    complain(top, exact,
             fmt::format("the grasps have {} rows together, but {} coordinates move them", rows,
                         count(all)),
             "let fewer points hold objects");
  }
}

std::vector<Eigen::Vector3d> points_on(const SceneObject& object) {
  std::vector<Eigen::Vector3d> points;
  for (const SceneGrasp& grasp : object.grasps) {
    const Eigen::Vector3d p(grasp.origin.xyz[0], grasp.origin.xyz[1], grasp.origin.xyz[2]);
    points.push_back(-(rotation_from_rpy<double>(grasp.origin.rpy).transpose() * p));
  }
  return points;
}

void check_linkage(const SceneElement& top, const SceneObject& object) {
  const std::vector<Eigen::Vector3d> r = points_on(object);
  const auto unit = [&r](std::size_t i, std::size_t j) { return (r[j] - r[i]).normalized(); };
  for (std::size_t i = 0; i < r.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if ((r[i] - r[j]).norm() > kFlat) continue;
      top.error(fmt::format("two grasps of object \"{}\" are at the same place: {} and {}",
                            object.name, object.grasps[j].point, object.grasps[i].point),
                "check the grasps' origins: the object's frame seen from each point");
      return;
    }
  }
  if (r.size() < 3) return;
  if (unit(0, 1).cross(unit(0, 2)).norm() < kFlat) {
    top.error(fmt::format("the first three grasps of object \"{}\" are on a line", object.name),
              "list three first that make a triangle");
  }
}

}  // namespace

void check_objects(const SceneElement& top, const Robot& robot, const Scene& scene) {
  if (scene.objects.empty()) return;
  check_freedoms(top, robot, scene);
  for (const SceneObject& object : scene.objects) check_linkage(top, object);
  if (std::none_of(scene.functions.begin(), scene.functions.end(), needs_objects)) {
    top.warn("objects are listed, but no function is about them",
             "add object_control_torque or object_forward_dynamics to functions");
  }
}

}  // namespace treeline
