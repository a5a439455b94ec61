#pragma once

#include <span>

#include "emission/emission_context.hpp"
#include "program/program.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Reports what cannot be emitted as valid code: names, empty arguments, divisions by a structural
/// zero, constants that Real cannot hold, what the language does not have.
void check_emission(const EmissionContext& context, std::span<const Program> programs,
                    Diagnostics& diagnostics);

}  // namespace treeline
