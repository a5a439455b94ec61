#pragma once

#include <cstddef>
#include <vector>

#include "description/heaviest_rows.hpp"
#include "interpreter/damped_torque.hpp"
#include "interpreter/points.hpp"
#include "oracle/chain_from_scene.hpp"
#include "oracle/entries.hpp"
#include "oracle/list_regressor_units.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline {

/// A body whose inertial parameters are an argument, and the matter that it may have: kg, within m
/// of the link's origin.
struct SubjectInertia {
  int body = 0;
  double mass = 0, reach = 0;
};

/// An operational point or a contact whose origin is an argument, with components up to `reach`, m.
struct SubjectTool {
  std::size_t point = 0;
  double reach = 0;
  bool orientation = false;  ///< its axes are an argument, too
};

/// What of the subject arguments change, see `SceneInputs`.
struct SubjectInputs {
  std::vector<SubjectInertia> payloads, parameters;
  std::vector<SubjectTool> tools, contacts;
};

/// Robot and scene in the interpreter's types.
template <class Scalar>
struct Subject {
  interpreter::Model<Scalar> model;
  interpreter::Points<Scalar> points;    ///< operational points
  interpreter::Points<Scalar> external;  ///< where external forces act
  interpreter::Points<Scalar> contacts;
  interpreter::Points<Scalar> constraints;  ///< whose rows are held
  interpreter::Loops<Scalar> loops;         ///< whose rows are held too
  std::vector<int> passive;                 ///< velocities without a motor
  interpreter::ClosedChain<Scalar> chain;   ///< with the objects that the robot holds
  interpreter::Damping<Scalar> damping;     ///< empty if the scene asks for no damping
  SubjectInputs inputs;                     ///< payloads are bodies of their own, without mass
  std::vector<interpreter::UnitParameter> regressor;  ///< the columns that the scene asks for

  [[nodiscard]] bool holds_rows() const { return !constraints.empty() || !loops.empty(); }
};

/// Fixes a body without mass to each link that carries a payload.
template <class Scalar>
void add_payloads(const Scene& scene, interpreter::Model<Scalar>& model) {
  for (const SceneInertia& payload : scene.inputs.payloads) {
    interpreter::Body<Scalar> body;
    body.name = "payload of " + payload.link;
    body.parent = find_body(model, payload.link);
    interpreter::add_body(model, body);
  }
}

inline std::vector<SubjectTool> tools_of(const std::vector<SceneTool>& named,
                                         const std::vector<ScenePoint>& points) {
  std::vector<SubjectTool> tools;
  for (const SceneTool& tool : named) {
    std::size_t point = 0;
    while (points[point].name != tool.point) ++point;
    tools.push_back({point, tool.reach, tool.orientation});
  }
  return tools;
}

/// `model` without payloads.
template <class Scalar>
SubjectInputs inputs_of(const Scene& scene, const interpreter::Model<Scalar>& model) {
  SubjectInputs inputs;
  for (const SceneInertia& payload : scene.inputs.payloads) {
    const int body = model.size() + static_cast<int>(inputs.payloads.size());
    inputs.payloads.push_back({body, payload.mass, payload.reach});
  }
  for (const SceneInertia& own : scene.inputs.parameters) {
    inputs.parameters.push_back({find_body(model, own.link), own.mass, own.reach});
  }
  inputs.tools = tools_of(scene.inputs.tools, scene.operational_points);
  inputs.contacts = tools_of(scene.inputs.contacts, scene.contacts);
  return inputs;
}

/// The columns of regressors, if the scene asks for some.
template <class Scalar>
std::vector<interpreter::UnitParameter> regressor_from_scene(
    const Robot& robot, const Scene& scene, const interpreter::Model<Scalar>& model) {
  std::vector<interpreter::UnitParameter> units;
  for (const UnitOfLink& unit : list_regressor_units(robot, scene)) {
    units.push_back({unit.kind, find_body(model, unit.link), unit.entry});
  }
  return units;
}

template <class Scalar>
Subject<Scalar> make_subject(const Robot& robot, const Scene& scene) {
  Subject<Scalar> subject;
  subject.model = model_from_robot<Scalar>(robot, scene);
  subject.points = points_from_scene(subject.model, scene.operational_points);
  subject.external = points_from_scene(subject.model, scene.external_forces);
  subject.contacts = points_from_scene(subject.model, scene.contacts);
  subject.constraints = points_from_scene(subject.model, scene.constraints);
  subject.loops = loops_from_scene(subject.model, robot, scene);
  subject.passive = passive_velocities(subject.model, robot, scene);
  if (!scene.objects.empty()) subject.chain = chain_from_scene<Scalar>(robot, scene);
  subject.damping.heaviest = vector_of<Scalar>(heaviest_rows(scene));
  // The values of `core::add_damping_by_directions`.
  subject.damping.resolution = Scalar(scene.real == Real::float32 ? 0x1p-17 : 0x1p-46);
  subject.inputs = inputs_of(scene, subject.model);
  subject.regressor = regressor_from_scene(robot, scene, subject.model);
  add_payloads(scene, subject.model);
  for (auto& robot_of_chain : subject.chain.robots) add_payloads(scene, robot_of_chain);
  return subject;
}

/// Converts every number to another type, rounding it once.
template <class To, class From>
Subject<To> cast(const Subject<From>& subject) {
  return {interpreter::cast<To>(subject.model),
          interpreter::cast<To>(subject.points),
          interpreter::cast<To>(subject.external),
          interpreter::cast<To>(subject.contacts),
          interpreter::cast<To>(subject.constraints),
          interpreter::cast<To>(subject.loops),
          subject.passive,
          interpreter::cast<To>(subject.chain),
          interpreter::cast<To>(subject.damping),
          subject.inputs,
          subject.regressor};
}

}  // namespace treeline
