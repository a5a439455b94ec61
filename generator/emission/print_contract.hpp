#pragma once

#include <span>
#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline {

/// NAME.hpp: where the code comes from, the order and units of joints and points, and a contract
/// for each function.
std::string print_contract(const EmissionContext& context, std::span<const Program> programs);

}  // namespace treeline
