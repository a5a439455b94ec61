#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "choice/function_mechanisms.hpp"
#include "generation/compose.hpp"
#include "generation/generate_code.hpp"
#include "passes/passes.hpp"
#include "recursion/routes/trace_function.hpp"

namespace treeline {
namespace {

Program called(Program program, const char* name) {
  program.name = name;
  return program;
}

/// Passes that a traced program goes through.
Program finish_ground(const Program& program, const char* name, const char* equation) {
  std::vector<PassReport> log;
  Program ordered = put_in_order(reduce_operations(canonicalize(program), log), log);
  ordered.equation = equation;
  return called(std::move(ordered), name);
}

/// The robot alone, with a point at the frame of each link that has a shape, in order of shapes.
Scene scene_of_links(const Scene& scene) {
  Scene links = scene;
  links.operational_points.clear();
  links.external_forces.clear();
  links.contacts.clear();
  for (const SceneTouch& shape : scene.touches) {
    auto& points = links.operational_points;
    const bool is_known = std::any_of(points.begin(), points.end(), [&](const ScenePoint& point) {
      return point.link == shape.link;
    });
    if (is_known) continue;
    ScenePoint point;
    point.name = point.link = shape.link;
    points.push_back(std::move(point));
  }
  return links;
}

/// A place of a link that moves with a group, seen from the frame of that.
Eigen::Vector3d seen_from(const Digits50Pose& pose, const std::array<double, 3>& place,
                          bool is_point) {
  const Digits50Vector3 p(place[0], place[1], place[2]);
  const Digits50Vector3 turned = pose.R * p;
  return (is_point ? Digits50Vector3(turned + pose.p) : turned).cast<double>();
}

std::array<double, 3> as_array(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

Eigen::Vector3d as_vector(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

GroundUnit::Shape shape_seen_from(const Digits50Pose& pose, const SceneTouch& shape) {
  GroundUnit::Shape seen;
  seen.radius = shape.radius;
  for (const auto& point : shape.points) {
    seen.points.push_back(as_array(seen_from(pose, point, true)));
  }
  const Eigen::Vector3d axis = seen_from(pose, shape.axis, false);
  if (axis.isZero(0)) return seen;
  seen.axis = as_array(axis);
  seen.level = as_array(axis.unitOrthogonal());
  return seen;
}

/// A ball about all points of a group, with a millionth to spare for rounding.
GroundUnit::Ball ball_around(const std::vector<GroundUnit::Shape>& shapes) {
  Eigen::AlignedBox3d box;
  for (const auto& shape : shapes) {
    for (const auto& point : shape.points) {
      box.extend(as_vector(point) + Eigen::Vector3d::Constant(shape.radius));
      box.extend(as_vector(point) - Eigen::Vector3d::Constant(shape.radius));
    }
  }
  const Eigen::Vector3d middle = box.center();
  double radius = 0;
  for (const auto& shape : shapes) {
    for (const auto& point : shape.points) {
      radius = std::max(radius, (as_vector(point) - middle).norm() + shape.radius);
    }
  }
  return {as_array(middle), radius * (1 + 1e-6)};
}

/// The last velocity that moves a link.
int last_velocity(const MovingLink& link) {
  return link.v_index + link.velocities() - 1;
}

/// Sorts the shapes into groups, and leaves of the mechanism's points the frame of each group.
std::vector<GroundUnit::Group> take_groups(const Scene& scene, Mechanism& mechanism) {
  std::vector<GroundUnit::Group> groups;
  std::vector<MechanismPoint> frames;
  std::stable_sort(mechanism.operational_points.begin(), mechanism.operational_points.end(),
                   [](const auto& a, const auto& b) { return a.link < b.link; });
  for (const MechanismPoint& point : mechanism.operational_points) {
    if (point.link < 0) continue;  // it cannot move
    auto frame = std::find_if(frames.begin(), frames.end(),
                              [&](const auto& each) { return each.link == point.link; });
    if (frame == frames.end()) {
      frame = frames.insert(frames.end(), point);
      GroundUnit::Group group;
      group.tip = last_velocity(mechanism.links[static_cast<std::size_t>(point.link)]);
      groups.push_back(std::move(group));
    }
    std::string& links = groups[static_cast<std::size_t>(frame - frames.begin())].links;
    links += (links.empty() ? "" : ", ") + point.name;
    const Digits50Pose pose = inverse(frame->pose) * point.pose;
    for (const SceneTouch& shape : scene.touches) {
      if (shape.link != point.name) continue;
      groups[static_cast<std::size_t>(frame - frames.begin())].shapes.push_back(
          shape_seen_from(pose, shape));
    }
  }
  for (GroundUnit::Group& group : groups) group.around = ball_around(group.shapes);
  mechanism.operational_points = std::move(frames);
  return groups;
}

std::vector<GroundUnit::Turn> list_turns(const Mechanism& mechanism) {
  std::vector<GroundUnit::Turn> turns;
  for (const MovingLink& link : mechanism.links) {
    if (link.quaternion() < 0) continue;
    turns.push_back({link.q_index, link.v_index, link.is_floating()});
  }
  return turns;
}

}  // namespace

GroundUnit compose_ground(const Robot& robot, const Scene& scene) {
  const Scene links = scene_of_links(scene);
  FunctionMechanisms mechanisms(robot, links);
  Mechanism mechanism = mechanisms.of(Function::lambda_inverse);
  GroundUnit unit;
  unit.friction = scene.ground_step->friction;
  unit.groups = take_groups(scene, mechanism);
  unit.before = velocities_before(mechanism);
  unit.coordinates = mechanism.nq();
  unit.turns = list_turns(mechanism);
  unit.flight = called(generate_function(mechanisms.of(Function::forward_dynamics),
                                         Function::forward_dynamics, route_options(links))
                           .program,
                       "ground_flight");
  unit.heights = finish_ground(trace_heights(mechanism, scene.lanes), "ground_heights",
                               "where the robot's shapes are above the ground");
  unit.dynamics = finish_ground(trace_for_impulses(mechanism, scene.lanes), "ground_dynamics",
                                "poses, motions and M = L^T D L for impulses");
  unit.energy = finish_ground(trace_energy(mechanisms.of(Function::kinetic_energy), scene.lanes),
                              "ground_energy", "T + U");
  return unit;
}

}  // namespace treeline
