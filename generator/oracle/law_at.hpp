#pragma once

#include <vector>

#include "interpreter/digits50.hpp"
#include "interpreter/task_law.hpp"
#include "recursion/task_law.hpp"

namespace treeline {

/// A generated function's law as the interpreter takes it, its axes where they are at `q`. Nothing
/// yields where `law` is null.
interpreter::TaskLaw<interpreter::Digits50> law_at(const TaskLaw* law,
                                                   const std::vector<double>& q);

}  // namespace treeline
