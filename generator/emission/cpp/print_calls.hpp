#pragma once

#include <span>
#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline::cpp {

/// NAME_calls.hpp: every function with a struct of named inputs, and with std::array.
std::string print_calls(const EmissionContext& context, std::span<const Program> programs);

}  // namespace treeline::cpp
