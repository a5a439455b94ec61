#pragma once

#include <vector>

#include "description/scene.hpp"
#include "interpreter/task_law.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/subject.hpp"

namespace treeline {

/// Results of one of `kContactFunctions` according to the interpreter: all entries of all results.
/// `law` is the generated function's task law at this state.
template <class Scalar>
std::vector<Scalar> interpret_contacts(Function function, const Subject<Scalar>& subject,
                                       const State& state,
                                       const interpreter::TaskLaw<Scalar>& law = {});

/// Frames of the links that move relative to their parents, as points with all rows in their own
/// axes, in the order of `link_inverse_inertias`.
interpreter::Points<double> link_frames(const interpreter::Model<double>& model);

}  // namespace treeline
