#pragma once

#include <vector>

#include "description/scene.hpp"
#include "interpreter/digits50.hpp"
#include "interpreter/task_law.hpp"
#include "oracle/draw_state.hpp"
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

}  // namespace treeline
