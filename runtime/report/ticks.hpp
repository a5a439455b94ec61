#pragma once

#include <string>
#include <vector>

namespace treeline::report {

/// Round numbers along an axis: multiples of 1, 2 or 5 times a power of ten.
struct Ticks {
  std::vector<double> values;
  int decimals = 0;  ///< digits after the decimal point that distinguish them
};

/// Returns at most `most` >= 2 ticks within [low, high], low < high.
Ticks round_ticks(double low, double high, int most);

/// Prints the number of a tick, with a true minus sign, and zero without sign.
std::string tick_label(double value, int decimals);

}  // namespace treeline::report
