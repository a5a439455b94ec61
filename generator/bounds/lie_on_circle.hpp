#pragma once

#include <vector>

namespace treeline {

/// Whether each sine and cosine are those of one angle, within a few `unit` (half an ulp of one).
/// Rounding bounds of functions with the inputs `sin_q` and `cos_q` hold only for such values.
bool lie_on_circle(const std::vector<double>& sines, const std::vector<double>& cosines,
                   double unit);

}  // namespace treeline
