#pragma once

#include <vector>

namespace treeline {

/// Whether sine and cosine of each angle are those of some angle, as far as `unit` (half an ulp of
/// one) can tell. Bounds of functions that take them hold there, and not in all of their box.
bool lie_on_circle(const std::vector<double>& sines, const std::vector<double>& cosines,
                   double unit);

}  // namespace treeline
