#pragma once

#include <string>

#include "bench/bench_report.hpp"

namespace treeline {

/// Time across and worst norm-wise error up, both logarithmic, a panel a function, the fronts
/// drawn: a stand-alone SVG file.
std::string draw_svg(const BenchReport& report);

}  // namespace treeline
