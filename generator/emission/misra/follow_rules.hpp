#pragma once

#include <string>

#include "emission/emission_context.hpp"

namespace treeline::misra {

/// Loops over links, which are written as templates, as `profile: misra` has them: without pragmas,
/// numbers as literals of their type and not by casts, integers of a stated size, the profile's
/// square root. Statements stay, and so do the bits of results. Throws std::logic_error where
/// something is left that the profile does not have.
std::string follow_rules(const EmissionContext& context, const std::string& code);

}  // namespace treeline::misra
