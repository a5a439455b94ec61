#pragma once

#include <string>
#include <string_view>

#include "emission/emission_context.hpp"

namespace treeline {

/// A header of `runtime/core/link_*.hpp`, with the macro TREELINE_LINK_INLINE where compilers are
/// told to inline what it marks. Else they decide: with `profile: misra`, which has no macros, and
/// where the target computes Real by calls, since there these are most of the code.
std::string settle_inlining(const EmissionContext& context, std::string_view header);

}  // namespace treeline
