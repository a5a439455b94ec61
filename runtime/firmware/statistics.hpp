#pragma once
// Distribution of durations on a microcontroller: C++17, freestanding, of chosen size.

#include <stddef.h>
#include <stdint.h>

namespace treeline::firmware {

/// Durations in ticks of a clock: exact least, largest and mean, and how many there were in each of
/// `bins` ranges. Bin 0 holds zeros, bin k durations from 2^(k-1) to 2^k - 1, the last one all that
/// are longer. Recording takes constant time but for the search of the leading bit. Counts, and
/// the mean, stop at their largest value.
template <size_t bins>
class Statistics {
 public:
  static_assert(bins >= 2 && bins <= 33, "a bin for zero and one for each bit at most");

  void record(uint32_t ticks) noexcept {
    if (counts_[bin_of(ticks)] != kMost) ++counts_[bin_of(ticks)];
    least_ = ticks < least_ ? ticks : least_;
    largest_ = ticks > largest_ ? ticks : largest_;
    if (count_ == kMost) return;
    ++count_;
    sum_ += ticks;
  }

  uint32_t count() const noexcept { return count_; }
  uint32_t least() const noexcept { return count_ == 0 ? 0 : least_; }
  uint32_t largest() const noexcept { return largest_; }
  uint32_t mean() const noexcept { return count_ == 0 ? 0 : static_cast<uint32_t>(sum_ / count_); }
  uint32_t count_of(size_t bin) const noexcept { return counts_[bin]; }

  static constexpr size_t bin_of(uint32_t ticks) noexcept {
    size_t bin = 0;
    while (ticks != 0) {
      ticks >>= 1;
      ++bin;
    }
    return bin < bins ? bin : bins - 1;
  }

 private:
  static constexpr uint32_t kMost = 0xffffffff;

  uint32_t counts_[bins] = {};
  uint64_t sum_ = 0;
  uint32_t count_ = 0;
  uint32_t least_ = kMost;
  uint32_t largest_ = 0;
};

}  // namespace treeline::firmware
