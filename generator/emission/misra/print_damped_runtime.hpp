#pragma once

#include <string>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"

namespace treeline::misra {

/// damped_solve.hpp and square_root.hpp: what NAME_damped.hpp needs, without templates.
std::vector<GeneratedFile> print_damped_runtime(const EmissionContext& context);

}  // namespace treeline::misra
