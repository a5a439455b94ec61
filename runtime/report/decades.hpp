#pragma once

#include <string>
#include <vector>

namespace treeline::report {

/// Range of a logarithmic axis, in powers of ten.
struct Decades {
  int first = 0, last = 1;
  /// Place of a value > 0 on an axis from 0 to 1.
  [[nodiscard]] double at(double value) const;
};

/// The decades that hold these values, all > 0, with room for `room` decades below the smallest.
Decades decades_of(const std::vector<double>& values, double room = 0);

/// Names a power of ten of nanoseconds: "10 µs".
std::string time_name(int decade);

}  // namespace treeline::report
