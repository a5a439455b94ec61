#include "report/ticks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace treeline::report {

Ticks round_ticks(double low, double high, int most) {
  const double wanted = (high - low) / std::max(1, most - 1);
  int power = static_cast<int>(std::floor(std::log10(wanted)));
  double step = 0.0;
  int digit = 0;
  for (const int candidate : {1, 2, 5, 10}) {
    digit = candidate;
    step = candidate * std::pow(10.0, power);
    if (step >= wanted * (1.0 - 1e-9)) {
      break;
    }
  }
  power += digit == 10 ? 1 : 0;
  Ticks ticks;
  ticks.decimals = std::max(0, -power);
  // Slightly beyond the ends, so that an end that is a tick up to rounding keeps its tick.
  const double first = std::ceil(low / step - 1e-9);
  const double last = std::floor(high / step + 1e-9);
  for (double i = first; i <= last; i += 1.0) {
    ticks.values.push_back(i * step);
  }
  return ticks;
}

std::string tick_label(double value, int decimals) {
  // Beyond five decimals a power of ten is easier to read. A tick has only a few significant
  // digits.
  std::string text = decimals > 5 && value != 0.0
                         ? fmt::format("{:.3g}", std::fabs(value))
                         : fmt::format("{:.{}f}", std::fabs(value), decimals > 5 ? 0 : decimals);
  const bool zero = text.find_first_not_of("0.") == std::string::npos;
  return value < 0.0 && !zero ? "\u2212" + text : text;
}

}  // namespace treeline::report
