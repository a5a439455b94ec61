#pragma once

#include <string>

namespace treeline {

/// Returns the shortest decimal text that reads back as exactly `value` (`0.1`, `2.0`, `1e-05`). It
/// always reads as a floating-point number.
std::string format_literal(double value);

/// Returns the shortest decimal text that reads back as exactly `value`, with the suffix `f`
/// (`0.1f`).
std::string format_literal(float value);

}  // namespace treeline
