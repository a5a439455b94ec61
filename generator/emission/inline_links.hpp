#pragma once

#include <string>
#include <string_view>

#include "emission/emission_context.hpp"

namespace treeline {

/// Whether functions of the loops that several functions of the robot call stand alone, for linkers
/// to keep one of them, or compilers decide.
enum class Sharing { linkers, compilers };

/// A header of `runtime/core/link_*.hpp`, with its macros where they are to tell compilers what
/// they mark: TREELINE_LINK_INLINE, what is inlined, and TREELINE_LINK_SHARED, what is not. Else
/// these decide: with `profile: misra`, which has no macros, and on inlining where the target
/// computes Real by calls, since there these are most of the code.
std::string settle_inlining(const EmissionContext& context, std::string_view header,
                            Sharing sharing);

}  // namespace treeline
