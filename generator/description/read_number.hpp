#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace treeline {

/// A decimal number that fills all of `text` but for outer white space, rounded to the nearest
/// double whatever the locale: 1e-400 is 0. A leading plus, `inf` and `-inf` are understood; NaN,
/// hexadecimal and numbers too large for a double are not.
std::optional<double> read_number(std::string_view text);

/// Whether a text that `read_number` reads as 0 says another number.
bool rounds_to_zero(std::string_view number);

/// Beyond these a number describes no robot, and products of a few of them leave the range of
/// double; of a larger angle, 50 digits say too little.
inline constexpr double kLargestNumber = 1e30;  ///< SI units
inline constexpr double kLargestAngle = 1e9;    ///< rad
bool is_too_large(double value, bool angle);

/// Whether an angle of an orientation, in rad, is more than a turn, with room for 2 pi as files
/// round it: somebody may have meant degrees.
bool is_beyond_a_turn(double angle);
inline constexpr const char* kRadiansForDegrees =
    "if these are degrees, write radians: degrees times 0.017453292519943295";

/// Numbers separated by white space, each as `read_number` has it; nothing when one is not a
/// finite number.
std::optional<std::vector<double>> read_numbers(std::string_view text);

/// Words of a text, which white space separates.
std::vector<std::string_view> split_words(std::string_view text);

/// `text` without white space at its ends.
std::string_view trimmed(std::string_view text);

}  // namespace treeline
