#pragma once

#include "program/program.hpp"
#include "recursion/methods/task_law.hpp"

namespace treeline {

/// Whether a candidate may only be chosen by its name, however cheap it is: see `TaskLaw`.
inline bool is_only_by_name(const Program& program) {
  return program.law && program.law->only_by_name;
}

}  // namespace treeline
