#pragma once

#include <vector>

#include "description/scene.hpp"
#include "functions/function.hpp"
#include "interpreter/digits50.hpp"
#include "interpreter/supported_control_torque.hpp"
#include "interpreter/task_law.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/entries.hpp"
#include "oracle/subject.hpp"

namespace treeline {

/// Results of a function according to the interpreter, in the order and layout of the generated
/// function's outputs, one after the other. For float, double and Digits50. `law` is the task law
/// of the generated function at this state, see `law_at`; the default means a plain solve.
template <class Scalar>
std::vector<Scalar> interpret(Function function, const Subject<Scalar>& subject, const State& state,
                              const interpreter::TaskLaw<Scalar>& law = {});

extern template std::vector<float> interpret(Function, const Subject<float>&, const State&,
                                             const interpreter::TaskLaw<float>&);
extern template std::vector<double> interpret(Function, const Subject<double>&, const State&,
                                              const interpreter::TaskLaw<double>&);
extern template std::vector<interpreter::Digits50> interpret(
    Function, const Subject<interpreter::Digits50>&, const State&,
    const interpreter::TaskLaw<interpreter::Digits50>&);

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

/// Results of one of `kContactFunctions` according to the interpreter: all entries of all results.
/// `law` is the generated function's task law at this state.
template <class Scalar>
std::vector<Scalar> interpret_contacts(Function function, const Subject<Scalar>& subject,
                                       const State& state,
                                       const interpreter::TaskLaw<Scalar>& law = {});

/// Frames of the links that move relative to their parents, as points with all rows in their own
/// axes, in the order of `link_inverse_inertias`.
interpreter::Points<double> link_frames(const interpreter::Model<double>& model);

/// Results of one of `kObjectFunctions` according to the interpreter, in the order of the contract.
/// For float, double and Digits50. `law` is the generated function's task law at this state.
template <class Scalar>
std::vector<Scalar> interpret_objects(Function function, const Subject<Scalar>& subject,
                                      const State& state,
                                      const interpreter::TaskLaw<Scalar>& law = {});

}  // namespace treeline
