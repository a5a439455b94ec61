#include "text/round_outward.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace treeline {
namespace {

std::string nearest(double value, int digits) {
  return fmt::format("{:.{}e}", value, digits - 1);
}

double read(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// What the last of so many digits of a number counts.
double last_place(double value, int digits) {
  const std::string text = nearest(value, 17);
  return read(fmt::format("1e{}", std::stoi(text.substr(text.find('e') + 1)) - (digits - 1)));
}

}  // namespace

double round_up(double value, int digits) {
  if (!std::isfinite(value)) return value;
  const double found = read(nearest(value, digits));
  return found >= value ? found : read(nearest(found + last_place(value, digits), digits));
}

double round_down(double value, int digits) {
  return -round_up(-value, digits);
}

std::string rounded_up(double value, int digits) {
  return nearest(round_up(value, digits), digits);
}

}  // namespace treeline
