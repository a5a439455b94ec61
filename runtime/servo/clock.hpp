#pragma once

#include <chrono>
#include <concepts>
#include <cstdint>
#include <thread>

namespace treeline::servo {

/// A source of time for the loop: nanoseconds since any fixed moment, and waiting.
template <class C>
concept Clock = requires(C& clock, std::int64_t time) {
  { clock.now() } -> std::same_as<std::int64_t>;
  clock.sleep_until(time);
};

/// The machine's monotonic clock.
class SteadyClock {
 public:
  std::int64_t now() const noexcept {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
  }
  void sleep_until(std::int64_t time) const {
    std::this_thread::sleep_until(
        std::chrono::steady_clock::time_point(std::chrono::nanoseconds(time)));
  }
};

/// A clock whose time passes only by waiting, so a simulation runs as fast as it can with exact
/// periods. With `advance` a test can let time pass within a cycle.
class SimulatedClock {
 public:
  std::int64_t now() const noexcept { return time_; }
  void sleep_until(std::int64_t time) noexcept { time_ = time > time_ ? time : time_; }
  void advance(std::int64_t nanoseconds) noexcept { time_ += nanoseconds; }

 private:
  std::int64_t time_ = 0;
};

}  // namespace treeline::servo
