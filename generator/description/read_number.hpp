#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace treeline {

/// A decimal number that fills all of `text` but for outer white space, rounded to the nearest
/// double whatever the locale. A leading plus, `inf` and `-inf` are understood; NaN, hexadecimal
/// and numbers too large for a double are not.
std::optional<double> read_number(std::string_view text);

/// Beyond these a number describes no robot, and products of a few of them leave the range of
/// double; of a larger angle, 50 digits say too little.
inline constexpr double kLargestNumber = 1e30;  ///< SI units
inline constexpr double kLargestAngle = 1e9;    ///< rad
bool is_too_large(double value, bool angle);

/// Numbers separated by white space, each as `read_number` has it; nothing when one is not a
/// finite number.
std::optional<std::vector<double>> read_numbers(std::string_view text);

/// What stands between white space.
std::vector<std::string_view> split_words(std::string_view text);

/// `text` without white space at its ends.
std::string_view trimmed(std::string_view text);

}  // namespace treeline
