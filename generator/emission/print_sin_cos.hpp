#pragma once

#include <string>
#include <string_view>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"

namespace treeline {

/// sin_cos.h: sine and cosine of one angle, and of several; for `profile: misra` without bits of
/// numbers, and then in C++ sin_cos.hpp too.
GeneratedFile print_sin_cos(const EmissionContext& context);

/// The header sin_cos.hpp of the runtime, for lanes of any number type, with the steps of
/// runtime/emitted in place of its includes. Throws std::out_of_range where one is missing.
std::string print_sines_in_lanes();

/// Sines by pointers, as headers of runtime/emitted take them, where a language has them by
/// references.
inline constexpr std::string_view kSinesByPointers =
    "TL_INLINE void tl_sin_cos_of(real x, real* sine, real* cosine) {\n"
    "  sin_cos(x, *sine, *cosine);\n}\n";

}  // namespace treeline
