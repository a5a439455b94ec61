#pragma once

#include <string>

#include "emission/emission_context.hpp"

namespace treeline::misra {

/// sin_cos.h or sin_cos.hpp for `profile: misra`: the polynomials of runtime/core/sin_cos.hpp,
/// around them comparisons and tables in place of the bits of numbers.
std::string print_sin_cos(const EmissionContext& context);

}  // namespace treeline::misra
