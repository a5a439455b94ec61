#include "case.hpp"

#include <algorithm>
#include <iostream>

#include "bench_robots.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "interpreter/points.hpp"
#include "oracle/model_from_robot.hpp"
#include "random_state.hpp"

namespace treeline::bench {
namespace {

std::vector<double> entries(const interpreter::Vector<double>& x) {
  return {x.data(), x.data() + x.size()};
}

}  // namespace

int Case::rows() const {
  return interpreter::row_count(points);
}

const std::vector<std::string>& robot_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const auto& robot : kRobots) result.emplace_back(robot.name);
    return result;
  }();
  return names;
}

std::optional<Case> read_case(const std::string& robot) {
  const auto* files = std::find_if(std::begin(kRobots), std::end(kRobots),
                                   [&](const auto& each) { return robot == each.name; });
  if (files == std::end(kRobots)) return std::nullopt;
  Diagnostics diagnostics;
  const auto read = read_urdf(files->urdf, diagnostics);
  const auto scene = read ? read_scene(files->scene, *read, diagnostics) : std::nullopt;
  if (!scene) {
    for (const auto& diagnostic : diagnostics.list()) std::cerr << to_string(diagnostic) << '\n';
    return std::nullopt;
  }
  std::string why_not;
  const auto description = describe_to_peers(*read, *scene, why_not);
  if (!description) {
    std::cerr << files->urdf << ": " << why_not << '\n';
    return std::nullopt;
  }
  Case result;
  result.robot = robot;
  result.description = *description;
  result.urdf = files->urdf;
  result.model = model_from_robot<double>(*read, *scene);
  result.points = points_from_scene<double>(result.model, scene->operational_points);
  return result;
}

std::vector<State> random_states(const Case& robot, int count, std::uint64_t seed) {
  using tests::random_entries;
  tests::Rng rng(seed);
  const int nv = robot.model.nv;
  std::vector<State> states;
  for (int i = 0; i < count; ++i) {
    State state;
    state.q = entries(tests::random_position<double>(rng, robot.model));
    state.qd = entries(random_entries<double>(rng, nv, 2));
    state.qdd = entries(random_entries<double>(rng, nv, 5));
    state.tau = entries(random_entries<double>(rng, nv, 20));
    state.xdd = entries(random_entries<double>(rng, robot.rows(), 5));
    states.push_back(std::move(state));
  }
  return states;
}

std::vector<const std::vector<double>*> inputs_of(Function function, const State& state) {
  switch (function) {
    case Function::inverse_dynamics:
    case Function::inverse_dynamics_derivatives:
      return {&state.q, &state.qd, &state.qdd};
    case Function::forward_dynamics:
    case Function::forward_dynamics_derivatives:
      return {&state.q, &state.qd, &state.tau};
    case Function::control_torque:
      return {&state.q, &state.qd, &state.qdd, &state.xdd};
    case Function::mass_matrix:
    case Function::mass_matrix_inverse:
    case Function::lambda_inverse:
    case Function::lambda:
      break;
  }
  return {&state.q};
}

int output_size(Function function, const Case& robot) {
  switch (function) {
    case Function::mass_matrix:
    case Function::mass_matrix_inverse:
      return robot.model.nv * robot.model.nv;
    case Function::lambda_inverse:
    case Function::lambda:
      return robot.rows() * robot.rows();
    case Function::inverse_dynamics_derivatives:
    case Function::forward_dynamics_derivatives:
      return 3 * robot.model.nv * robot.model.nv;
    case Function::inverse_dynamics:
    case Function::forward_dynamics:
    case Function::control_torque:
      break;
  }
  return robot.model.nv;
}

std::string name_of(Function function) {
  switch (function) {
    case Function::inverse_dynamics:
      return "inverse_dynamics";
    case Function::forward_dynamics:
      return "forward_dynamics";
    case Function::mass_matrix:
      return "mass_matrix";
    case Function::mass_matrix_inverse:
      return "mass_matrix_inverse";
    case Function::lambda_inverse:
      return "lambda_inverse";
    case Function::lambda:
      return "lambda";
    case Function::inverse_dynamics_derivatives:
      return "inverse_dynamics_derivatives";
    case Function::forward_dynamics_derivatives:
      return "forward_dynamics_derivatives";
    case Function::control_torque:
      break;
  }
  return "control_torque";
}

}  // namespace treeline::bench
