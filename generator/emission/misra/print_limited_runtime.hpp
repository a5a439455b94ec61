#pragma once

#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"

namespace treeline::misra {

/// What NAME_limited.hpp includes in C++: the loops of limited control as in C, with the same bits.
/// They include square_root.hpp.
std::vector<GeneratedFile> print_limited_runtime(const EmissionContext& context);

}  // namespace treeline::misra
