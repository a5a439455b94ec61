#include "tumbler.hpp"

#include <algorithm>

#include "description/read_urdf.hpp"
#include "interpreter/instances.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline::experiments {

std::optional<simulation::Model> load_floating(const std::string& urdf, std::string& error) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(urdf, diagnostics);
  if (!robot) {
    for (const Diagnostic& diagnostic : diagnostics.list()) {
      if (!error.empty()) error += '\n';
      error += to_string(diagnostic);
    }
    return std::nullopt;
  }
  Scene scene;
  scene.base = Base::floating;
  return model_from_robot<double>(*robot, scene);
}

int body_named(const simulation::Model& model, const std::string& name) {
  const auto found = std::find_if(model.bodies.begin(), model.bodies.end(),
                                  [&](const auto& body) { return body.name == name; });
  return static_cast<int>(found - model.bodies.begin());
}

simulation::State tumbler_start(const simulation::Model& model, double height) {
  simulation::State state{simulation::Vector::Zero(model.nq), simulation::Vector::Zero(model.nv)};
  state.q(2) = height;
  state.q.segment<4>(3) << 0.2, 0.1, 0.3, 1.0;
  state.q.segment<4>(3).normalize();
  for (int i = 7; i < model.nq; ++i) {
    state.q(i) = 0.3 * (i % 3 - 1) + 0.05 * i;
  }
  state.qd.segment<3>(3) << 0.5, -1.0, 0.7;
  return state;
}

simulation::Vector3 center_of_mass(const simulation::Model& model, const simulation::Vector& q) {
  const auto k = interpreter::kinematics<double>(model, q, simulation::Vector::Zero(model.nv));
  simulation::Vector3 moment = simulation::Vector3::Zero();
  double mass = 0;
  for (int i = 0; i < model.size(); ++i) {
    moment += model.body(i).mass * (k.p_world[i] + k.R_world[i] * model.body(i).com);
    mass += model.body(i).mass;
  }
  return moment / mass;
}

}  // namespace treeline::experiments
