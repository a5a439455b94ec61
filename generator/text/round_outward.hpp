#pragma once

#include <string>

namespace treeline {

/// The least decimal of so many significant digits that is not below `value`: what is told of a
/// bound has to be a bound. What is not finite stays as it is.
double round_up(double value, int digits);

/// The greatest that is not above it: of a range in which a bound holds.
double round_down(double value, int digits);

/// Prints a bound with so many digits, as 1.3e-15.
std::string rounded_up(double value, int digits);

}  // namespace treeline
