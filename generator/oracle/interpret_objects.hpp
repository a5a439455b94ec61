#pragma once

#include <vector>

#include "description/scene.hpp"
#include "interpreter/task_law.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/subject.hpp"

namespace treeline {

/// Results of one of `kObjectFunctions` according to the interpreter, in the order of the contract.
/// For float, double and Digits50. `law` is the generated function's task law at this state.
template <class Scalar>
std::vector<Scalar> interpret_objects(Function function, const Subject<Scalar>& subject,
                                      const State& state,
                                      const interpreter::TaskLaw<Scalar>& law = {});

}  // namespace treeline
