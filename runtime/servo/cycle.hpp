#pragma once

#include <cstdint>

#include "servo/clock.hpp"
#include "servo/statistics.hpp"

namespace treeline::servo {

/// Timing of one cycle, in nanoseconds.
struct CycleTiming {
  std::int64_t period = 0;   ///< since the previous cycle began; 0 in the first
  std::int64_t jitter = 0;   ///< delay of the cycle's beginning
  std::int64_t busy = 0;     ///< from begin_cycle to end_cycle
  std::int64_t slack = 0;    ///< time left before the next tick; negative if it was missed
  std::int64_t skipped = 0;  ///< ticks that passed while this cycle was running
};

/// A fixed-rate loop: `begin_cycle(); ...; end_cycle();`. Ticks lie on a grid that the first cycle
/// fixes, so delays never accumulate. A cycle that overruns skips the ticks that it has missed.
template <Clock ClockType>
class Cycle {
 public:
  Cycle(ClockType& clock, std::int64_t period_nanoseconds) noexcept
      : clock_(clock), period_(period_nanoseconds) {}

  /// Records the beginning of a cycle. The first call fixes the grid.
  void begin_cycle() {
    const std::int64_t now = clock_.now();
    if (!started_) {
      started_ = true;
      tick_ = now;
      begin_ = now;
    } else {
      timing_.period = now - begin_;
      periods_.record(timing_.period);
    }
    begin_ = now;
    timing_.jitter = now - tick_;
    jitters_.record(timing_.jitter);
  }

  /// Records the end of the work and waits for the next tick in the future.
  void end_cycle() {
    finish();
    clock_.sleep_until(tick_);
  }

  /// Records the end of the work, wakes `lead` nanoseconds before the next tick for `prepare()`, if
  /// so much time is left, and waits for the tick.
  template <class Prepare>
  void end_cycle(std::int64_t lead, Prepare&& prepare) {
    finish();
    if (clock_.now() < tick_ - lead) {
      clock_.sleep_until(tick_ - lead);
      prepare();
    }
    clock_.sleep_until(tick_);
  }

  /// Timing of the cycle in progress. Until `end_cycle`, busy, slack and skipped are those of the
  /// previous cycle.
  const CycleTiming& timing() const noexcept { return timing_; }
  const DurationStatistics& periods() const noexcept { return periods_; }
  const DurationStatistics& jitters() const noexcept { return jitters_; }
  const DurationStatistics& busy() const noexcept { return busy_; }
  const DurationStatistics& slacks() const noexcept { return slacks_; }
  /// Number of ticks skipped since the start.
  std::uint64_t skips() const noexcept { return skips_; }
  std::int64_t period() const noexcept { return period_; }

 private:
  void finish() {
    const std::int64_t now = clock_.now();
    timing_.busy = now - begin_;
    timing_.slack = tick_ + period_ - now;
    timing_.skipped = timing_.slack < 0 ? (-timing_.slack + period_ - 1) / period_ : 0;
    busy_.record(timing_.busy);
    slacks_.record(timing_.slack);
    skips_ += static_cast<std::uint64_t>(timing_.skipped);
    tick_ += (1 + timing_.skipped) * period_;
  }

  ClockType& clock_;
  std::int64_t period_;
  bool started_ = false;
  std::int64_t tick_ = 0;
  std::int64_t begin_ = 0;
  CycleTiming timing_;
  DurationStatistics periods_;
  DurationStatistics jitters_;
  DurationStatistics busy_;
  DurationStatistics slacks_;
  std::uint64_t skips_ = 0;
};

}  // namespace treeline::servo
