#pragma once

#include <vector>

#include "description/scene.hpp"
#include "interpreter/task_law.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/subject.hpp"

namespace treeline {

/// The results of one of `kObjectFunctions` by the interpreter, in the order of the contract. For
/// float, double and 50 digits.
template <class Scalar>
std::vector<Scalar> interpret_objects(Function function, const Subject<Scalar>& subject,
                                      const State& state,
                                      const interpreter::TaskLaw<Scalar>& law = {});

}  // namespace treeline
