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

/// What the state has for an argument that a scene may be without.
std::vector<double> optional_argument(const State& state, const char* name);

}  // namespace treeline
