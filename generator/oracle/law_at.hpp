#pragma once

#include <memory>
#include <vector>

#include "interpreter/digits50.hpp"
#include "interpreter/task_law.hpp"
#include "recursion/methods/task_law.hpp"

namespace treeline {

/// Task law of a generated function in the interpreter's types, with the axes that it has at `q`
/// and with the operational points where arguments have them. If `law` is null, no row is relaxed.
interpreter::TaskLaw<interpreter::Digits50> law_at(const TaskLaw* law, const std::vector<double>& q,
                                                   const GivenTools& tools = {});

/// Task law for finding the sizes of a function's results. Scales of forces follow from Lambda, so
/// a law on the Jacobian is replaced by the one on Lambda^-1. Null if `law` is.
std::shared_ptr<const TaskLaw> law_of_sizes(const std::shared_ptr<const TaskLaw>& law);

}  // namespace treeline
