#pragma once

#include <span>
#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline::cpp {

/// NAME.hpp: the conventions, and the declaration of each function below its contract.
std::string print_contract(const EmissionContext& context, std::span<const Program> programs);

}  // namespace treeline::cpp
