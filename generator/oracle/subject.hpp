#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "description/effective_mass_limits.hpp"
#include "generation/base_parameter_domain.hpp"
#include "interpreter/damped_torque.hpp"
#include "interpreter/points.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/chain_from_scene.hpp"
#include "oracle/entries.hpp"
#include "oracle/list_regressor_units.hpp"
#include "oracle/model_from_robot.hpp"
#include "recursion/parameters/base_parameters.hpp"

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

/// A base parameter: the parameter that it is named after and what it combines.
struct SubjectBase {
  interpreter::UnitParameter named;
  std::vector<std::pair<interpreter::UnitParameter, Digits50>> terms;
  std::vector<std::pair<std::size_t, double>> numbers;  ///< the same of the numbers of `BaseDomain`
};

/// What of the subject arguments change, see `SceneInputs`.
struct SubjectInputs {
  std::vector<SubjectInertia> payloads, parameters;
  std::vector<SubjectTool> tools, contacts;
  std::vector<SubjectInertia> base_bodies;  ///< each with what is fixed to it
  std::vector<double> base_drives;          ///< sizes of rotors and coefficients of friction
  std::vector<SubjectBase> base;
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

template <class Scalar>
interpreter::UnitParameter unit_on(const interpreter::Model<Scalar>& model,
                                   const UnitOfLink& unit) {
  return {unit.kind, find_body(model, unit.link), unit.entry, unit.slip_speed};
}

/// The columns of regressors, if the scene asks for some.
template <class Scalar>
std::vector<interpreter::UnitParameter> regressor_from_scene(
    const Robot& robot, const Scene& scene, const interpreter::Model<Scalar>& model,
    const Mechanism* mechanism) {
  std::vector<interpreter::UnitParameter> units;
  for (const UnitOfLink& unit : list_regressor_units(robot, scene, mechanism)) {
    units.push_back(unit_on(model, unit));
  }
  return units;
}

/// Makes base parameters of the model an argument: bodies that are fixed to others are part of
/// these.
template <class Scalar>
void add_base_parameters(const Robot& robot, const Mechanism& mechanism,
                         interpreter::Model<Scalar>& model, SubjectInputs& inputs) {
  const auto found = base_parameters_of(mechanism);
  const BaseDomain domain = base_parameter_domain(mechanism);
  inputs.base_drives = domain.drives;
  for (auto& body : model.bodies) {
    const bool of_file = std::any_of(robot.links.begin(), robot.links.end(),
                                     [&](const Link& link) { return link.name == body.name; });
    if (!of_file) continue;  // a rotor of the scene
    body.mass = Scalar(0);
    body.inertia.setZero();
  }
  for (std::size_t k = 0; k < domain.bodies.size(); ++k) {
    const SceneInertia& within = domain.bodies[k];
    inputs.base_bodies.push_back({find_body(model, within.link), within.mass, within.reach});
    auto& body = model.bodies[static_cast<std::size_t>(inputs.base_bodies.back().body)];
    body.mass = Scalar(1);  // first moments are no matter of a massless body here
    body.com.setZero();
  }
  for (std::size_t k = 0; k < found->base.size(); ++k) {
    const BaseParameter& base = found->base[k];
    const auto unit = [&](std::size_t parameter) {
      return unit_on(model, unit_of_link(found->parameters[parameter], robot));
    };
    SubjectBase& own = inputs.base.emplace_back();
    own.named = unit(base.parameter);
    own.numbers = domain.rows[k];
    for (const auto& [parameter, coefficient] : base.combination) {
      own.terms.emplace_back(unit(parameter), coefficient);
    }
  }
}

/// `mechanism`, if it is there already, is that of the robot in the scene.
template <class Scalar>
Subject<Scalar> make_subject(const Robot& robot, const Scene& scene,
                             const Mechanism* mechanism = nullptr) {
  Subject<Scalar> subject;
  subject.model = model_from_robot<Scalar>(robot, scene);
  subject.points = points_from_scene(subject.model, scene.operational_points);
  subject.external = points_from_scene(subject.model, scene.external_forces);
  subject.contacts = points_from_scene(subject.model, scene.contacts);
  subject.constraints = points_from_scene(subject.model, scene.constraints);
  subject.loops = loops_from_scene(subject.model, robot, scene);
  subject.passive = passive_velocities(subject.model, robot, scene);
  if (!scene.objects.empty()) subject.chain = chain_from_scene<Scalar>(robot, scene);
  subject.damping.effective_mass_limits = vector_of<Scalar>(effective_mass_limits(scene));
  // The values of `core::damped_solve`.
  subject.damping.resolution = Scalar(scene.real == Real::float32 ? 0x1p-17 : 0x1p-46);
  subject.inputs = inputs_of(scene, subject.model);
  subject.regressor = regressor_from_scene(robot, scene, subject.model, mechanism);
  if (scene.inputs.base_parameters) {
    const auto add = [&](const Mechanism& built) {
      add_base_parameters(robot, built, subject.model, subject.inputs);
      for (auto& of_chain : subject.chain.robots) {
        SubjectInputs same;
        add_base_parameters(robot, built, of_chain, same);
      }
    };
    mechanism != nullptr ? add(*mechanism) : add(build_mechanism(robot, scene));
  }
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
