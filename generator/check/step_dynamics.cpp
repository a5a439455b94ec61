#include "check/step_dynamics.hpp"

#include <algorithm>
#include <utility>

#include "emission/controller_unit.hpp"
#include "oracle/interpret.hpp"
#include "oracle/subject_at.hpp"

namespace treeline {
namespace {

/// The scene with all six rows of every operational point, in world axes.
Scene with_all_rows(Scene scene) {
  for (ScenePoint& point : scene.operational_points) {
    point.axes = Axes::world;
    point.rows.fill(true);
  }
  return scene;
}

std::vector<GeneratedFunction> list_functions(const ControllerUnit& unit) {
  std::vector<GeneratedFunction> functions;
  for (const Program* const program : unit.programs()) {
    functions.emplace_back().program = *program;
  }
  return functions;
}

State state_of(const Program& program, const long double* const* in, std::size_t velocities) {
  State state;
  state.qd.assign(velocities, 0);
  state.qdd.assign(velocities, 0);
  for (std::size_t i = 0; i < program.arguments.size(); ++i) {
    const Argument& argument = program.arguments[i];
    const auto quantity = find_quantity(argument.name);
    const bool is_sine = quantity && (*quantity == Quantity::sin_q || *quantity == Quantity::cos_q);
    if (!quantity || is_sine) continue;  // sines follow from q
    std::vector<double>& place = place_of(state, *quantity);
    place.clear();
    for (int k = 0; k < argument.rows * argument.cols; ++k) {
      place.push_back(static_cast<double>(in[i][k]));
    }
  }
  return state;
}

template <class T>
std::vector<long double> widened(const std::vector<T>& entries) {
  std::vector<long double> wide;
  for (const T& x : entries) wide.push_back(static_cast<long double>(x));
  return wide;
}

}  // namespace

StepDynamics::StepDynamics(const Robot& robot, const Scene& scene, const Generation& generation,
                           std::uint64_t seed)
    : generation_(generation),
      functions_(list_functions(*generation.controller)),
      exact_(make_subject<Digits50>(robot, scene, &generation.mechanism)),
      pushed_(generation.controller->push_torque
                  ? make_subject<Digits50>(robot, with_all_rows(scene))
                  : Subject<Digits50>()),
      single_(cast<float>(exact_)),
      space_(make_state_space(robot, scene, generation.mechanism, functions_, seed)),
      unit_(unit_of(scene.real)) {
  space_.subject = cast<double>(exact_);
}

State StepDynamics::draw(int index) const {
  for (; class_of_state(index) != StateClass::random; ++index) {
  }
  return draw_state(space_, index);
}

std::vector<double> StepDynamics::accelerate(State state) const {
  if (state.others.contains(Quantity::step)) state.others.erase(Quantity::step);
  return interpret<double>(Function::forward_dynamics, *SubjectAt(space_.subject, state), state);
}

std::vector<double> StepDynamics::poses(const State& state) const {
  return interpret<double>(Function::forward_kinematics, *SubjectAt(space_.subject, state), state);
}

std::vector<long double> StepDynamics::run(Function function, const TaskLaw* law,
                                           const State& state) const {
  const GivenTools tools{values_of(state, Quantity::tool),
                         values_of(state, Quantity::tool_orientation)};
  const auto at = law_at(law, state.q, tools);
  if (fifty_) return widened(interpret<Digits50>(function, *SubjectAt(exact_, state), state, at));
  if (space_.single_precision) {
    return widened(interpret<float>(function, *SubjectAt(single_, state), state,
                                    interpreter::cast<float>(at)));
  }
  return widened(interpret<double>(function, *SubjectAt(space_.subject, state), state,
                                   interpreter::cast<double>(at)));
}

/// tau = -J^T f for forces and moments on all points.
std::vector<long double> StepDynamics::push(const State& state) const {
  const auto J =
      widened(interpret<Digits50>(Function::jacobian, *SubjectAt(pushed_, state), state));
  const std::size_t velocities = state.qd.size();
  std::vector<long double> tau(velocities, 0);
  for (std::size_t row = 0; row < state.f_ext.size(); ++row) {
    for (std::size_t i = 0; i < velocities; ++i) {
      tau[i] -= J[(row * velocities) + i] * static_cast<long double>(state.f_ext[row]);
    }
  }
  return tau;
}

std::vector<long double> StepDynamics::interpret_result(const Program& program,
                                                        const std::string& result,
                                                        const State& state) const {
  const std::size_t points = generation_.controller->points.size();
  const auto split = static_cast<std::ptrdiff_t>(3 * points);
  if (result == "g") return run(Function::gravity, nullptr, state);
  if (result == "velocity") return run(Function::point_velocity, nullptr, state);
  if (result == "position" || result == "rotation") {
    const auto poses = run(Function::forward_kinematics, nullptr, state);
    return result == "position" ? std::vector<long double>(poses.begin(), poses.begin() + split)
                                : std::vector<long double>(poses.begin() + split, poses.end());
  }
  const ControllerUnit& unit = *generation_.controller;
  if (unit.push_torque && program.name == unit.push_torque->name) return push(state);
  if (unit.task_torque && program.name == unit.task_torque->name) {
    return run(Function::control_torque, unit.task_torque->law.get(), state);
  }
  return run(Function::inverse_dynamics, nullptr, state);
}

void StepDynamics::compute(void* with, int index, const long double* const* in,
                           long double* const* out) {
  const auto& own = *static_cast<const StepDynamics*>(with);
  const Program& program = own.functions_[static_cast<std::size_t>(index)].program;
  const State state = state_of(program, in, own.generation_.controller->joints.size());
  for (std::size_t i = 0; i < program.results.size(); ++i) {
    const auto entries = own.interpret_result(program, program.results[i].argument.name, state);
    std::copy(entries.begin(), entries.end(), out[i]);
  }
}

}  // namespace treeline
