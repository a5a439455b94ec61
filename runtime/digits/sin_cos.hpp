#pragma once

#include "digits/digits50.hpp"

namespace treeline::digits {

/// Whether `sine` and `cosine` take the angle: below 1e12 rad.
bool is_reducible(const Digits50& angle);
/// Within a few of the last bits.
Digits50 sine(const Digits50& angle);
Digits50 cosine(const Digits50& angle);

}  // namespace treeline::digits
