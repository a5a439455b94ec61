#pragma once

#include <string>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"

namespace treeline::misra {

/// square_root.h or square_root.hpp for `profile: misra`: Heron's steps whose last digit integers
/// decide, and tables of powers of four in place of the bits of numbers.
GeneratedFile print_square_root(const EmissionContext& context);

/// damped_solve.hpp and square_root.hpp: what NAME_damped.hpp needs, without templates.
std::vector<GeneratedFile> print_damped_runtime(const EmissionContext& context);

}  // namespace treeline::misra
