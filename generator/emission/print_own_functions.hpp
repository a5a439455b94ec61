#pragma once

#include <string>
#include <vector>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline {

/// The header STEM_functions: declares functions that only an add-on calls, whose contract is
/// NAME_STEM.h. `what` says who calls them: "the controller".
std::string print_own_functions(const EmissionContext& context,
                                const std::vector<const Program*>& programs,
                                const std::string& stem, const std::string& what);

/// The source of one of them, which includes that header.
std::string print_own_source(const EmissionContext& context, const Program& program,
                             const std::string& stem);

/// The call of one of them, or of another function of the robot, in a hole of a body. `arguments`
/// are written, with commas between.
std::string print_own_call(const EmissionContext& context, const Program& program,
                           const std::string& arguments);

}  // namespace treeline
