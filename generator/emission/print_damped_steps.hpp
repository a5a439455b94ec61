#pragma once

#include <map>
#include <string>

#include "emission/emission_context.hpp"

namespace treeline {

/// Words for templates that are C and C++ without templates: `inline`, `bool`, `int`, the prefix of
/// names, arguments that are written to (`ref`, `value`, `address`), and `noexcept`.
std::map<std::string, std::string> list_phrases(const EmissionContext& context);

/// The loops of damped control, in the number type and for the task's rows: those of
/// runtime/core/damped_solve.hpp in C, or in C++ without templates.
std::string print_damped_steps(const EmissionContext& context);

}  // namespace treeline
