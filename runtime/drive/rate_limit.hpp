#pragma once

namespace treeline::drive {

/// A bucket of permissions that fills at a rate: bounds how many messages a connection may send.
class RateLimit {
 public:
  RateLimit(double per_second, double burst) noexcept
      : per_second_(per_second), burst_(burst), left_(burst) {}

  /// Whether one more may pass at `now` (s), which does not go back.
  bool admits(double now) noexcept {
    left_ += started_ ? (now - last_) * per_second_ : 0.0;
    left_ = left_ > burst_ ? burst_ : left_;
    started_ = true;
    last_ = now;
    if (left_ < 1.0) {
      return false;
    }
    left_ -= 1.0;
    return true;
  }

 private:
  double per_second_;
  double burst_;
  double left_;
  double last_ = 0.0;
  bool started_ = false;
};

/// How many messages a front end may send: drags are frequent, the stops of a watcher are not.
inline RateLimit rate_for(bool may_command) noexcept {
  return may_command ? RateLimit(200.0, 100.0) : RateLimit(10.0, 10.0);
}

/// How many front ends without the token may join: each costs its `hello` in the thread that serves
/// those who command.
inline RateLimit rate_of_watchers() noexcept {
  return {20.0, 64.0};
}

}  // namespace treeline::drive
