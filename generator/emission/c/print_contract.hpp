#pragma once

#include <span>
#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline::c {

/// NAME.h: the conventions, and the declaration of each function below its contract. C++ may
/// include it too.
std::string print_contract(const EmissionContext& context, std::span<const Program> programs);

/// The declaration of each function below its contract.
std::string print_declarations(const EmissionContext& context, std::span<const Program> programs);

}  // namespace treeline::c
