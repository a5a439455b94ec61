#pragma once

#include <memory>
#include <vector>

#include "interpreter/digits50.hpp"
#include "interpreter/task_law.hpp"
#include "recursion/task_law.hpp"

namespace treeline {

/// A generated function's law as the interpreter takes it, its axes where they are at `q`. Nothing
/// yields where `law` is null.
interpreter::TaskLaw<interpreter::Digits50> law_at(const TaskLaw* law,
                                                   const std::vector<double>& q);

/// The law by which the sizes of a function's results are found: the scale of forces comes out of
/// Lambda, also where it is the Jacobian that is eliminated. Null where `law` is.
std::shared_ptr<const TaskLaw> law_of_sizes(const std::shared_ptr<const TaskLaw>& law);

}  // namespace treeline
