#pragma once

#include <cmath>
#include <limits>

namespace treeline {

/// State of a joint's limit in a file.
enum class LimitState { absent, stated, implausible };

/// Placeholder that exporters write where nobody has filled in a limit, so that it is none.
enum class Placeholder {
  none,
  zero,      ///< no speed, or no force
  negative,  ///< of a speed or a force
  enormous,  ///< more than anything reaches
  reversed,  ///< the lower end is above the upper one
  equal,     ///< the lower end is the upper one
};

/// A limit of a joint: the number that holds, infinite unless a file states one. What counts as
/// stated is decided in `read_joint_limits` alone, so that all who read a limit agree.
class Limit {
 public:
  /// Stated where the number is finite, else absent.
  Limit(double value) : value_(value), written_(value) {}

  /// `written` is a placeholder; `none` is the infinity that stands for no limit.
  static Limit implausible(Placeholder placeholder, double written, double none) {
    Limit limit(none);
    limit.placeholder_ = placeholder;
    limit.written_ = written;
    return limit;
  }

  [[nodiscard]] LimitState state() const {
    if (placeholder_ != Placeholder::none) return LimitState::implausible;
    return std::isfinite(value_) ? LimitState::stated : LimitState::absent;
  }
  [[nodiscard]] bool is_stated() const { return state() == LimitState::stated; }
  [[nodiscard]] double value() const { return value_; }
  operator double() const { return value_; }

  [[nodiscard]] Placeholder placeholder() const { return placeholder_; }
  [[nodiscard]] double written() const { return written_; }  ///< as in the file

 private:
  double value_, written_;
  Placeholder placeholder_ = Placeholder::none;
};

/// Limits of a joint: rad or m, N m or N, rad/s or m/s.
struct Limits {
  Limit lower = -std::numeric_limits<double>::infinity();
  Limit upper = std::numeric_limits<double>::infinity();
  Limit effort = std::numeric_limits<double>::infinity();
  Limit velocity = std::numeric_limits<double>::infinity();
  int line = 0;  ///< of the element in the file
};

}  // namespace treeline
