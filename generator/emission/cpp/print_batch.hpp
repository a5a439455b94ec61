#pragma once

#include <span>
#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline::cpp {

/// `NAME_batch.hpp`, which declares the programs' functions for `context.batch` states a call.
std::string print_batch_header(const EmissionContext& context, std::span<const Program> programs);

/// The source file that defines one of them, `batch_FUNCTION.cpp`.
std::string print_batch_source(const EmissionContext& context, const Program& program);

}  // namespace treeline::cpp
