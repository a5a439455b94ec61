#pragma once

namespace treeline::drive {

/// A motion that was recorded. The arrays belong to somebody else and outlive the loop.
struct RecordedMotion {
  const double* times = nullptr;  ///< `rows` entries that grow, s
  const double* q = nullptr;      ///< rows x nq, rad and m
  int rows = 0;                   ///< 0: there is none; otherwise at least 2
};

/// A coordinate of a motion at a moment.
struct ReferencePoint {
  double position = 0.0, velocity = 0.0, acceleration = 0.0;
};

/// Runs through a recorded motion: cubic Hermite segments with the slopes of central differences,
/// which begin and end at rest. Nothing is allocated.
class ReferenceMotion {
 public:
  ReferenceMotion() = default;
  ReferenceMotion(const RecordedMotion& recorded, int nq) noexcept : recorded_(recorded), nq_(nq) {}

  bool exists() const noexcept { return recorded_.rows > 1; }
  bool playing() const noexcept { return playing_; }
  /// Begins the motion: its first row is for the time `time` (s).
  void begin(double time) noexcept {
    start_ = time;
    row_ = 0;
    playing_ = true;
  }
  void end() noexcept { playing_ = false; }
  /// Whether it has begun at `time`.
  bool begun(double time) const noexcept { return playing_ && time >= start_; }
  /// Whether it has ended at `time`.
  bool ended(double time) const noexcept {
    return time - start_ >= recorded_.times[recorded_.rows - 1] - recorded_.times[0];
  }

  /// Goes on to `time`, not before that of the last call.
  void seek(double time) noexcept {
    at_ = recorded_.times[0] + (time - start_);
    while (row_ < recorded_.rows - 2 && recorded_.times[row_ + 1] <= at_) {
      ++row_;
    }
  }
  /// Coordinate i at the time of the last `seek`.
  ReferencePoint sample(int i) const noexcept {
    const double h = recorded_.times[row_ + 1] - recorded_.times[row_];
    const double s = (at_ - recorded_.times[row_]) / h;
    const double from = entry(row_, i);
    const double to = entry(row_ + 1, i);
    const double m0 = h * slope(row_, i);
    const double m1 = h * slope(row_ + 1, i);
    const double c2 = 3.0 * (to - from) - 2.0 * m0 - m1;
    const double c3 = 2.0 * (from - to) + m0 + m1;
    return {from + s * (m0 + s * (c2 + s * c3)), (m0 + s * (2.0 * c2 + 3.0 * s * c3)) / h,
            (2.0 * c2 + 6.0 * s * c3) / (h * h)};
  }
  /// Coordinate i where the motion begins.
  double first(int i) const noexcept { return entry(0, i); }

 private:
  double entry(int row, int i) const noexcept { return recorded_.q[row * nq_ + i]; }
  double slope(int row, int i) const noexcept {
    if (row == 0 || row == recorded_.rows - 1) {
      return 0.0;
    }
    return (entry(row + 1, i) - entry(row - 1, i)) /
           (recorded_.times[row + 1] - recorded_.times[row - 1]);
  }

  RecordedMotion recorded_;
  int nq_ = 0;
  bool playing_ = false;
  double start_ = 0.0;
  double at_ = 0.0;
  int row_ = 0;
};

}  // namespace treeline::drive
