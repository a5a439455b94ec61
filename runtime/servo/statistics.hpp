#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace treeline::servo {

/// Distribution of durations in nanoseconds: exact minimum, maximum and mean, and quantiles within
/// 0.4 % (a histogram with 128 bins per power of two). The size is fixed. Recording takes constant
/// time and never allocates.
class DurationStatistics {
 public:
  /// Records a duration. Negative durations count as 0.
  void record(std::int64_t nanoseconds) noexcept {
    const std::int64_t value = nanoseconds < 0 ? 0 : nanoseconds;
    ++counts_[bin_of(static_cast<std::uint64_t>(value))];
    ++count_;
    sum_ += static_cast<double>(value);
    minimum_ = value < minimum_ ? value : minimum_;
    maximum_ = value > maximum_ ? value : maximum_;
  }

  std::uint64_t count() const noexcept { return count_; }
  double minimum() const noexcept { return count_ == 0 ? 0.0 : static_cast<double>(minimum_); }
  double maximum() const noexcept { return static_cast<double>(maximum_); }
  double mean() const noexcept { return count_ == 0 ? 0.0 : sum_ / static_cast<double>(count_); }
  double median() const noexcept { return quantile(0.5); }

  /// Smallest duration that at least the share `fraction` of all durations does not exceed, 0 <=
  /// fraction <= 1: the middle of its bin, within the recorded extremes. 0 if nothing was recorded.
  double quantile(double fraction) const noexcept {
    const double wanted = fraction * static_cast<double>(count_);
    std::uint64_t below = 0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      below += counts_[bin];
      if (below > 0 && static_cast<double>(below) >= wanted) {
        const double middle = 0.5 * static_cast<double>(first_of(bin) + first_of(bin + 1) - 1);
        return middle < minimum() ? minimum() : (middle > maximum() ? maximum() : middle);
      }
    }
    return maximum();
  }

 private:
  static constexpr int kBinBits = 7;
  static constexpr std::size_t kPerOctave = std::size_t{1} << kBinBits;
  static constexpr std::size_t kBins = (64 - kBinBits) * kPerOctave;

  // Values below kPerOctave have a bin each. For larger values, the bits after the leading one
  // determine the bin.
  static constexpr std::size_t bin_of(std::uint64_t value) noexcept {
    if (value < kPerOctave) {
      return static_cast<std::size_t>(value);
    }
    const int shift = static_cast<int>(std::bit_width(value)) - 1 - kBinBits;
    return static_cast<std::size_t>(shift) * kPerOctave + static_cast<std::size_t>(value >> shift);
  }
  static constexpr std::uint64_t first_of(std::size_t bin) noexcept {
    if (bin < 2 * kPerOctave) {
      return bin;
    }
    const std::size_t shift = bin / kPerOctave - 1;
    return static_cast<std::uint64_t>(bin - shift * kPerOctave) << shift;
  }

  std::array<std::uint32_t, kBins> counts_{};
  std::uint64_t count_ = 0;
  std::int64_t minimum_ = std::numeric_limits<std::int64_t>::max();
  std::int64_t maximum_ = 0;
  double sum_ = 0.0;
};

}  // namespace treeline::servo
