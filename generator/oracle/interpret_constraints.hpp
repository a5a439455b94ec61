#pragma once

#include <vector>

#include "functions/function.hpp"
#include "interpreter/supported_control_torque.hpp"
#include "interpreter/task_law.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/entries.hpp"
#include "oracle/subject.hpp"

namespace treeline {

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
          subject.loops};
}

/// Results of a function about constraints or passive joints, like `interpret`.
template <class Scalar>
std::vector<Scalar> interpret_constraints(Function function, const Subject<Scalar>& subject,
                                          const State& state,
                                          const interpreter::TaskLaw<Scalar>& law);

}  // namespace treeline
