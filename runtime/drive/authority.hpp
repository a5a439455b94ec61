#pragma once

#include <optional>

namespace treeline::drive {

/// Who commands the robot, among front ends that are known by numbers. Times are in s of any clock
/// that does not go back.
class Authority {
 public:
  /// A holder that has been silent so long can be relieved, s.
  static constexpr double kSilence = 10.0;

  /// Whether a command of this front end is to be obeyed. Takes the command if it is free.
  bool obeys(int front_end, double now) noexcept {
    if (!holder_) {
      holder_ = front_end;
    }
    if (*holder_ != front_end) {
      return false;
    }
    heard_ = now;
    return true;
  }

  /// Asks for the command. Returns whether it is granted: it is free, or its holder is silent.
  /// Otherwise the front end is remembered, and gets it when the holder gives it up.
  bool take(int front_end, double now) noexcept {
    if (!holder_ || *holder_ == front_end || now - heard_ > kSilence) {
      holder_ = front_end;
      heard_ = now;
      waiting_ = waiting_ == front_end ? std::nullopt : waiting_;
      return true;
    }
    waiting_ = front_end;
    return false;
  }

  /// Gives the command up: to the front end that asked last, else to nobody. Returns whether this
  /// front end had it.
  bool give(int front_end, double now) noexcept {
    if (holder_ != front_end) {
      return false;
    }
    holder_ = waiting_;
    waiting_ = std::nullopt;
    heard_ = now;
    return true;
  }

  /// A front end has gone.
  void leave(int front_end, double now) noexcept {
    waiting_ = waiting_ == front_end ? std::nullopt : waiting_;
    give(front_end, now);
  }

  std::optional<int> holder() const noexcept { return holder_; }

 private:
  std::optional<int> holder_;
  std::optional<int> waiting_;
  double heard_ = 0.0;
};

}  // namespace treeline::drive
