#include "oracle/subject.hpp"

#include <algorithm>

#include "choice/base_parameter_domain.hpp"
#include "description/scene_queries.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/entries.hpp"
#include "oracle/list_regressor_units.hpp"
#include "oracle/model_from_robot.hpp"
#include "recursion/parameters/base_parameters.hpp"

namespace treeline {
namespace {

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

std::vector<SubjectTool> tools_of(const std::vector<SceneTool>& named,
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
  inputs.active = find_active_rows(scene);
  for (const std::string& name : scene.inputs.active_tasks) {
    std::size_t point = 0;
    while (scene.operational_points[point].name != name) ++point;
    inputs.active_tasks.push_back(point);
  }
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

}  // namespace

template <class Scalar>
Subject<Scalar> make_subject(const Robot& robot, const Scene& scene, const Mechanism* mechanism) {
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

template Subject<double> make_subject(const Robot&, const Scene&, const Mechanism*);
template Subject<Digits50> make_subject(const Robot&, const Scene&, const Mechanism*);

template <class To>
Subject<To> cast(const Subject<Digits50>& subject) {
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

template Subject<float> cast(const Subject<Digits50>&);
template Subject<double> cast(const Subject<Digits50>&);

}  // namespace treeline
