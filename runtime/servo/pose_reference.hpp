#pragma once

#include "core/orientation.hpp"
#include "core/spline.hpp"

namespace treeline::servo {

/// Desired motion of a frame in world axes, linear over angular.
struct PoseMotion {
  double position[3] = {};
  double rotation[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  double velocity[6] = {};
  double acceleration[6] = {};
};

/// Desired pose of a frame over time: held, or moved from rest to rest along a straight line and
/// about a fixed axis, both by the same cubic in time.
class PoseReference {
 public:
  /// Holds this pose.
  void hold(const double (&position)[3], const double (&rotation)[9]) noexcept {
    move(0.0, position, rotation, position, rotation, 1.0);
  }

  /// Moves from one pose at `start_time` (s) to another `duration` > 0 seconds later. The poses are
  /// held before and after.
  void move(double start_time, const double (&from_position)[3], const double (&from_rotation)[9],
            const double (&to_position)[3], const double (&to_rotation)[9],
            double duration) noexcept {
    start_time_ = start_time;
    line_ = core::rest_to_rest(from_position, to_position, duration);
    core::orientation_error(from_rotation, to_rotation, turn_);
    const double nothing[1] = {0.0};
    const double all[1] = {1.0};
    fraction_ = core::rest_to_rest(nothing, all, duration);
    for (int i = 0; i < 9; ++i) {
      from_rotation_[i] = from_rotation[i];
    }
  }

  /// When its last motion began, and how long it takes, s.
  double start_time() const noexcept { return start_time_; }
  double duration() const noexcept { return line_.duration; }

  PoseMotion at(double time) const noexcept {
    const auto line = line_.at(time - start_time_);
    const auto fraction = fraction_.at(time - start_time_);
    PoseMotion motion;
    double partial[3];
    for (int i = 0; i < 3; ++i) {
      motion.position[i] = line.position[i];
      motion.velocity[i] = line.velocity[i];
      motion.acceleration[i] = line.acceleration[i];
      partial[i] = fraction.position[0] * turn_[i];
      motion.velocity[3 + i] = fraction.velocity[0] * turn_[i];
      motion.acceleration[3 + i] = fraction.acceleration[0] * turn_[i];
    }
    double rotation[9];
    core::rotation_from_vector(partial, rotation);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        motion.rotation[3 * i + j] = rotation[3 * i] * from_rotation_[j] +
                                     rotation[3 * i + 1] * from_rotation_[3 + j] +
                                     rotation[3 * i + 2] * from_rotation_[6 + j];
      }
    }
    return motion;
  }

 private:
  double start_time_ = 0.0;
  core::CubicSegment<3, double> line_{};
  core::CubicSegment<1, double> fraction_{};
  double turn_[3] = {};  ///< rotation vector of the whole rotation, world axes
  double from_rotation_[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
};

}  // namespace treeline::servo
