#pragma once

#include "digits/digits50.hpp"

namespace treeline::digits {

/// Whether `sine` and `cosine` accept the angle: below 1e12 rad.
bool is_reducible(const Digits50& angle);
/// Sine and cosine of an angle (rad), with errors of a few units of the last bit.
Digits50 sine(const Digits50& angle);
Digits50 cosine(const Digits50& angle);

}  // namespace treeline::digits
