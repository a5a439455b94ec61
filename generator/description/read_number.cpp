#include "description/read_number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace treeline {
namespace {

constexpr std::string_view kWhiteSpace = " \t\r\n\f\v";

/// Part of a number before its exponent.
std::string_view significand(std::string_view number) {
  return number.substr(0, number.find_first_of("eE"));
}

/// Whether a decimal number that no double is near is too small, not too large: its first digit
/// that is not 0 stands behind the point once the exponent has moved it.
bool is_tiny(std::string_view number) {
  const std::string_view digits = significand(number);
  const auto first = static_cast<long>(digits.find_first_of("123456789"));
  const auto point = static_cast<long>(std::min(digits.find('.'), digits.size()));
  long exponent = 0;
  if (digits.size() < number.size()) {
    const bool has_plus = number[digits.size() + 1] == '+';
    const char* const begin = number.data() + digits.size() + (has_plus ? 2 : 1);
    const auto read = std::from_chars(begin, number.data() + number.size(), exponent);
    if (read.ec == std::errc::result_out_of_range) return *begin == '-';
  }
  return point - first + exponent <= 0;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kWhiteSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kWhiteSpace) - first + 1);
}

std::optional<double> read_number(std::string_view text) {
  text = trimmed(text);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || std::isnan(value)) return std::nullopt;
  if (error == std::errc::result_out_of_range && is_tiny(text)) {
    return text.front() == '-' ? -0.0 : 0.0;
  }
  if (error != std::errc{}) return std::nullopt;
  return value;
}

bool rounds_to_zero(std::string_view number) {
  return significand(number).find_first_of("123456789") != std::string_view::npos;
}

bool is_too_large(double value, bool angle) {
  return std::abs(value) > (angle ? kLargestAngle : kLargestNumber);
}

bool is_beyond_a_turn(double angle) {
  return std::abs(angle) > 6.3;
}

std::vector<std::string_view> split_words(std::string_view text) {
  std::vector<std::string_view> words;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const auto length = std::min(text.find_first_of(kWhiteSpace), text.size());
    words.push_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  return words;
}

std::optional<std::vector<double>> read_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view word : split_words(text)) {
    const auto number = read_number(word);
    if (!number || !std::isfinite(*number)) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace treeline
