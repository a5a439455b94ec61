#include "bounds/lie_on_circle.hpp"

#include <algorithm>
#include <cmath>

namespace treeline {

bool lie_on_circle(const std::vector<double>& sines, const std::vector<double>& cosines,
                   double unit) {
  for (std::size_t i = 0; i < std::min(sines.size(), cosines.size()); ++i) {
    // Sine and cosine may each be off by two units; squaring doubles that.
    const double off = sines[i] * sines[i] + cosines[i] * cosines[i] - 1;
    if (!(std::abs(off) <= 8 * unit)) return false;
  }
  return true;
}

}  // namespace treeline
