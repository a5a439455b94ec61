#pragma once

#include <vector>

#include "functions/function.hpp"
#include "interpreter/supported_control_torque.hpp"
#include "interpreter/task_law.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/entries.hpp"
#include "oracle/subject.hpp"

namespace treeline {

/// The shares to which rows are held at a state; empty where no constraint comes and goes.
template <class Scalar>
interpreter::Vector<Scalar> held_shares(const Subject<Scalar>& subject, const State& state) {
  const int rows = interpreter::row_count<Scalar>(subject.constraints) +
                   interpreter::row_count<Scalar>(subject.loops);
  return vector_of<Scalar>(shares_of_rows(subject.inputs.active, static_cast<std::size_t>(rows),
                                          values_of(state, Quantity::active)));
}

/// A supported task of the subject at a state, in the interpreter's types.
template <class Scalar>
interpreter::SupportedTask<Scalar> supported_task(const Subject<Scalar>& subject,
                                                  const State& state) {
  return {subject.constraints,
          subject.points,
          subject.passive,
          vector_of<Scalar>(state.qdd),
          vector_of<Scalar>(state.xdd_cmd),
          vector_of<Scalar>(values_of(state, Quantity::f_wanted)),
          subject.external,
          vector_of<Scalar>(state.f_ext),
          subject.loops,
          held_shares(subject, state)};
}

/// Results of a function about constraints or passive joints, like `interpret`.
template <class Scalar>
std::vector<Scalar> interpret_constraints(Function function, const Subject<Scalar>& subject,
                                          const State& state,
                                          const interpreter::TaskLaw<Scalar>& law);

}  // namespace treeline
