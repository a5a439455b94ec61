#include "drive/report.hpp"

#include <algorithm>
#include <cmath>

namespace treeline::drive {

LoopTiming::LoopTiming(double rate)
    : cycles_per_second_(static_cast<std::size_t>(std::max(1.0, std::round(rate)))) {
  const double half = 0.5 * static_cast<double>(kHistogramBins) * kHistogramWidth;
  period_.first = std::max(0.0, 1e6 / rate - half);
}

void LoopTiming::Series::take(double microseconds) {
  second.push_back(microseconds);
  const double bin = std::floor((microseconds - first) / kHistogramWidth);
  const double last = static_cast<double>(kHistogramBins - 1);
  ++histogram[static_cast<std::size_t>(std::clamp(bin, 0.0, last))];
}

void LoopTiming::Series::show() {
  if (second.empty()) {
    shown = {};
    return;
  }
  double sum = 0.0;
  for (const double value : second) sum += value;
  const auto count = static_cast<double>(second.size());
  const auto rank = static_cast<std::ptrdiff_t>(std::floor(0.99 * (count - 1.0)));
  std::nth_element(second.begin(), second.begin() + rank, second.end());
  shown = {sum / count, second[static_cast<std::size_t>(rank)],
           *std::max_element(second.begin(), second.end())};
  second.clear();
}

void LoopTiming::take(const ReportHead& head) {
  constexpr double kMicro = 1e-3;
  if (head.control_time > 0) control_.take(kMicro * static_cast<double>(head.control_time));
  if (head.period > 0) period_.take(kMicro * static_cast<double>(head.period));
  jitter_.take(kMicro * static_cast<double>(head.jitter));
  overruns_ += static_cast<std::uint64_t>(head.skipped);
  saturated_ = saturated_ || head.saturated;
  if (++cycles_ % cycles_per_second_ != 0) return;
  control_.show();
  period_.show();
  jitter_.show();
  saturated_shown_ = saturated_;
  saturated_ = false;
}

}  // namespace treeline::drive
