#pragma once

#include <vector>

#include "description/scene.hpp"
#include "interpreter/task_law.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/subject.hpp"

namespace treeline {

/// One of `kContactFunctions` by the interpreter: all entries of all results.
template <class Scalar>
std::vector<Scalar> interpret_contacts(Function function, const Subject<Scalar>& subject,
                                       const State& state,
                                       const interpreter::TaskLaw<Scalar>& law = {});

/// The frames of the links that move against their parents, as points with all rows in their own
/// axes, in the order of `link_inverse_inertias`.
interpreter::Points<double> link_frames(const interpreter::Model<double>& model);

}  // namespace treeline
