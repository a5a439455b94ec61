#pragma once

#include <string>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"

namespace treeline {

/// Constants and types that NAME_limited.h declares: sizes, outcomes, limits. In C++ they stand in
/// torque_limits.hpp.
std::string print_limit_types(const EmissionContext& context);

/// The headers of runtime/emitted that limited control includes, but square_root.h, with those of a
/// robot's sizes. `context` has `limits`.
std::vector<GeneratedFile> print_limit_headers(const EmissionContext& context);

}  // namespace treeline
