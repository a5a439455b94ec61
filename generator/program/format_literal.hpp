#pragma once

#include <string>

namespace treeline {

/// The shortest decimal text that reads back as exactly `value` (`0.1`, `2.0`, `1e-05`); it always
/// reads as a floating-point number.
std::string format_literal(double value);

/// The same for float, with the suffix `f`.
std::string format_literal(float value);

}  // namespace treeline
