#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace treeline::stress {

/// Relative change of a conserved quantity, sampled at numbers of steps that grow by a quarter of a
/// decade: the largest since the previous sample.
struct Drift {
  std::vector<double> at;  ///< log10 of steps
  std::vector<double> y;   ///< log10 of the drift
};

template <class Step, class Off>
Drift run(int steps, const Step& step, const Off& off) {
  Drift drift;
  double largest = 0;
  double next = 2;
  for (int i = 1; i <= steps; ++i) {
    step(i);
    largest = std::max(largest, off());
    if (i < std::lround(std::pow(10.0, next))) continue;
    drift.at.push_back(next);
    drift.y.push_back(std::log10(std::max(largest, 1e-17)));
    largest = 0;
    next += 0.25;
  }
  return drift;
}

}  // namespace treeline::stress
