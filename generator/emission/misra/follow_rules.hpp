#pragma once

#include <string>

#include "emission/emission_context.hpp"

namespace treeline::misra {

/// Code of a controller, which is written in templates, as `profile: misra` has it: without
/// pragmas, numbers as literals of their type and not by casts, integers of a stated size, the
/// profile's square root. Statements stay, and so do the bits of results. Throws std::logic_error
/// where something is left that the profile does not have.
std::string follow_rules(const EmissionContext& context, const std::string& code);

/// Applies `follow_rules` to a header. Arrays have lengths from controller_sizes.hpp, not from an
/// argument of a template, whose sign compilers would warn of.
std::string follow_rules_in_header(const EmissionContext& context, const std::string& code);

/// controller_sizes.hpp. `context` has a controller.
std::string print_controller_sizes(const EmissionContext& context);

}  // namespace treeline::misra
