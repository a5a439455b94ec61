#pragma once

#include <cstddef>
#include <vector>

#include "oracle/draw_state.hpp"
#include "oracle/subject.hpp"

namespace treeline {

/// Gives a body the ten inertial parameters that begin at `first`.
template <class Scalar>
void set_parameters(const std::vector<double>& entries, std::size_t first,
                    interpreter::Body<Scalar>& body) {
  const auto at = [&](std::size_t i) { return Scalar(entries[first + i]); };
  body.mass = at(0);
  body.com = {at(1), at(2), at(3)};
  if (body.mass != Scalar(0)) body.com /= body.mass;
  body.inertia << at(4), at(5), at(7),  //
      at(5), at(6), at(8),              //
      at(7), at(8), at(9);
}

/// Gives bodies the parameters of a state, in their order; none if the state has none.
template <class Scalar>
void set_all_parameters(const std::vector<SubjectInertia>& bodies,
                        const std::vector<double>& entries, interpreter::Model<Scalar>& model) {
  for (std::size_t i = 0; kInertialParameters * i < entries.size(); ++i) {
    set_parameters(entries, kInertialParameters * i,
                   model.bodies[static_cast<std::size_t>(bodies[i].body)]);
  }
}

template <class Scalar>
void change_model(const SubjectInputs& inputs, const State& state,
                  interpreter::Model<Scalar>& model) {
  const std::vector<double>& gravity = values_of(state, Quantity::gravity);
  if (!gravity.empty()) {
    model.gravity = {Scalar(gravity[0]), Scalar(gravity[1]), Scalar(gravity[2])};
  }
  set_all_parameters(inputs.payloads, values_of(state, Quantity::payload), model);
  set_all_parameters(inputs.parameters, values_of(state, Quantity::parameters), model);
}

/// The subject with what the state says of gravity, payloads, inertial parameters and tools.
template <class Scalar>
Subject<Scalar> subject_at(Subject<Scalar> subject, const State& state) {
  change_model(subject.inputs, state, subject.model);
  for (auto& robot : subject.chain.robots) change_model(subject.inputs, state, robot);
  const std::vector<double>& tool = values_of(state, Quantity::tool);
  for (std::size_t i = 0; 3 * i < tool.size(); ++i) {
    subject.points[subject.inputs.tools[i].point].p = {Scalar(tool[3 * i]), Scalar(tool[3 * i + 1]),
                                                       Scalar(tool[3 * i + 2])};
  }
  return subject;
}

}  // namespace treeline
