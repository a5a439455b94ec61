#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "drive/robot_library.hpp"

namespace treeline::drive {

/// One report of the loop.
struct LoopReport {
  ReportHead head;
  std::vector<double> numbers;  ///< see `ReportLayout`
};

/// Durations of the last second that has passed, us.
struct Durations {
  double mean = 0.0, p99 = 0.0, max = 0.0;
};

/// Counts of durations: entry i counts those from i to i + 1 widths; the last all that are longer.
inline constexpr std::size_t kHistogramBins = 64;
inline constexpr double kHistogramWidth = 10.0;  ///< us
using Histogram = std::array<std::uint64_t, kHistogramBins>;

/// Statistics of the loop's timing, from all reports.
class LoopTiming {
 public:
  /// `rate` of the loop, Hz.
  explicit LoopTiming(double rate);

  void take(const ReportHead& head);

  const Durations& control() const { return control_.shown; }
  const Durations& period() const { return period_.shown; }
  const Durations& jitter() const { return jitter_.shown; }
  const Histogram& control_histogram() const { return control_.histogram; }
  const Histogram& period_histogram() const { return period_.histogram; }
  const Histogram& jitter_histogram() const { return jitter_.histogram; }
  /// Where the histogram of periods begins, us: half a histogram below the nominal period.
  double first_period() const { return period_.first; }
  std::uint64_t overruns() const { return overruns_; }
  bool saturated() const { return saturated_shown_; }

 private:
  struct Series {
    double first = 0.0;  ///< us, where the histogram begins
    std::vector<double> second;
    Durations shown;
    Histogram histogram{};
    void take(double microseconds);
    void show();
  };

  std::size_t cycles_per_second_;
  Series control_, period_, jitter_;
  std::size_t cycles_ = 0;
  std::uint64_t overruns_ = 0;
  bool saturated_ = false, saturated_shown_ = false;
};

}  // namespace treeline::drive
