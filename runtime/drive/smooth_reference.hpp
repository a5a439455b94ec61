#pragma once

#include "core/orientation.hpp"
#include "drive/reference_motion.hpp"

namespace treeline::drive {

/// A number that is led over time with continuous position, velocity and acceleration: along a
/// polynomial of the fifth degree to a goal at rest, or behind a target that a hand moves.
class SmoothNumber {
 public:
  /// Begins at `x` with velocity `v` (per s) and glides to rest near it.
  void begin(double time, double x, double v) noexcept {
    x_ = x;
    v_ = v;
    a_ = 0.0;
    now_ = time;
    hold(time);
  }

  /// Moves to rest at `to` in `duration` > 0 seconds. It goes on from where it was when it advanced
  /// last, so that no cycle is lost.
  void move(double time, double to, double duration) noexcept {
    start_ = now_;
    duration = time + duration - now_;
    duration_ = duration;
    following_ = false;
    target_ = to;
    const double d = to - x_;
    const double v = v_ * duration;
    const double a = a_ * duration * duration;
    coefficients_[0] = x_;
    coefficients_[1] = v;
    coefficients_[2] = 0.5 * a;
    coefficients_[3] = 10.0 * d - 6.0 * v - 1.5 * a;
    coefficients_[4] = -15.0 * d + 8.0 * v + 1.5 * a;
    coefficients_[5] = 6.0 * d - 3.0 * v - 0.5 * a;
  }

  /// Glides to rest: at once if it rests.
  void hold(double time) noexcept {
    const bool rests = v_ == 0.0 && a_ == 0.0;
    move(time, x_ + 0.4 * kGlide * v_, rests ? kShortest : kGlide);
  }

  /// Follows `target` at no more than `speed`, until another call.
  void follow(double target, double speed) noexcept {
    if (!following_) {
      smooth_target_ = x_ + 2.0 * v_ / kPull + a_ / (kPull * kPull);
      following_ = true;
    }
    target_ = target;
    speed_ = speed;
  }

  /// Is where somebody else leads it, at `time`.
  void lead(double time, const ReferencePoint& to) noexcept {
    x_ = to.position;
    v_ = to.velocity;
    a_ = to.acceleration;
    target_ = to.position;
    start_ = time;
    now_ = time;
    duration_ = kShortest;
    following_ = false;
    coefficients_[0] = x_;
    for (int i = 1; i < 6; ++i) {
      coefficients_[i] = 0.0;
    }
  }

  /// Advances to `time`, which is `dt` seconds after the last call.
  void advance(double time, double dt) noexcept {
    now_ = time;
    if (following_) {
      advance_following(dt);
      return;
    }
    const double s = (time - start_) / duration_;
    if (s >= 1.0) {
      x_ = target_;
      v_ = 0.0;
      a_ = 0.0;
      return;
    }
    const double(&c)[6] = coefficients_;
    const double rate = 1.0 / duration_;
    x_ = c[0] + s * (c[1] + s * (c[2] + s * (c[3] + s * (c[4] + s * c[5]))));
    v_ = rate * (c[1] + s * (2.0 * c[2] + s * (3.0 * c[3] + s * (4.0 * c[4] + s * 5.0 * c[5]))));
    a_ = rate * rate * (2.0 * c[2] + s * (6.0 * c[3] + s * (12.0 * c[4] + s * 20.0 * c[5])));
  }

  /// When it was begun, advanced or led last, s.
  double now() const noexcept { return now_; }
  double position() const noexcept { return x_; }
  double velocity() const noexcept { return v_; }
  double acceleration() const noexcept { return a_; }
  double target() const noexcept { return target_; }
  bool following() const noexcept { return following_; }
  /// Whether it has not come to its goal at `time`.
  bool moving(double time) const noexcept { return following_ || time < start_ + duration_; }

 private:
  static constexpr double kGlide = 0.4;       ///< s
  static constexpr double kShortest = 1e-3;   ///< s
  static constexpr double kPull = 25.0;       ///< 1/s: how quickly a target is followed
  static constexpr double kSmoothing = 25.0;  ///< 1/s: how quickly steps of the target pass

  void advance_following(double dt) noexcept {
    double rate = kSmoothing * (target_ - smooth_target_);
    rate = rate > speed_ ? speed_ : rate < -speed_ ? -speed_ : rate;
    smooth_target_ += dt * rate;
    a_ = kPull * kPull * (smooth_target_ - x_) - 2.0 * kPull * v_;
    v_ += dt * a_;
    x_ += dt * v_;
  }

  double x_ = 0.0;
  double v_ = 0.0;
  double a_ = 0.0;
  double now_ = 0.0;
  double start_ = 0.0;
  double duration_ = kShortest;
  double coefficients_[6] = {};
  double target_ = 0.0;
  double smooth_target_ = 0.0;
  double speed_ = 0.0;
  bool following_ = false;
};

/// A pose that is led over time, in world axes. It turns about fixed axes: R = exp(r(t)) R_0, where
/// r is smooth. If a turn is interrupted by one about another axis, the velocity that is fed
/// forward is that of the first order in r; feedback corrects the rest.
class SmoothPose {
 public:
  void begin(double time, const double (&position)[3], const double (&rotation)[9],
             const double (&velocity)[6]) noexcept {
    for (int i = 0; i < 3; ++i) {
      position_[i].begin(time, position[i], velocity[i]);
    }
    for (int i = 0; i < 9; ++i) {
      rotation_[i] = rotation[i];
    }
    rebase();
    for (int i = 0; i < 3; ++i) {
      turn_[i].begin(time, 0.0, velocity[3 + i]);
    }
    remember_goal();
  }

  void move(double time, const double (&to)[3], double duration) noexcept {
    for (int i = 0; i < 3; ++i) {
      position_[i].move(time, to[i], duration);
    }
  }

  void turn(double time, const double (&to)[9], double duration) noexcept {
    double angles[3];
    aim(to, angles);
    for (int i = 0; i < 3; ++i) {
      const double v = turn_[i].velocity();
      turn_[i].begin(turn_[i].now(), 0.0, v);
      turn_[i].move(time, angles[i], duration);
    }
  }

  void follow_position(const double (&to)[3], double speed) noexcept {
    for (int i = 0; i < 3; ++i) {
      position_[i].follow(to[i], speed);
    }
  }

  void follow_rotation(const double (&to)[9], double speed) noexcept {
    double angles[3];
    aim(to, angles);
    for (int i = 0; i < 3; ++i) {
      const double v = turn_[i].velocity();
      turn_[i].begin(turn_[i].now(), 0.0, v);
      turn_[i].follow(angles[i], speed);
    }
  }

  void hold(double time) noexcept {
    for (int i = 0; i < 3; ++i) {
      position_[i].hold(time);
      turn_[i].hold(time);
    }
    remember_goal();
  }

  void advance(double time, double dt) noexcept {
    double angles[3];
    for (int i = 0; i < 3; ++i) {
      position_[i].advance(time, dt);
      turn_[i].advance(time, dt);
      angles[i] = turn_[i].position();
    }
    apply_turn(angles, rotation_);
  }

  void position(double (&out)[3]) const noexcept {
    for (int i = 0; i < 3; ++i) {
      out[i] = position_[i].position();
    }
  }
  const double (&rotation() const noexcept)[9] { return rotation_; }
  /// Goal position, where the motion ends.
  void goal_position(double (&out)[3]) const noexcept {
    for (int i = 0; i < 3; ++i) {
      out[i] = position_[i].target();
    }
  }
  const double (&goal_rotation() const noexcept)[9] { return goal_rotation_; }
  double velocity(int row) const noexcept {
    return row < 3 ? position_[row].velocity() : turn_[row - 3].velocity();
  }
  double acceleration(int row) const noexcept {
    return row < 3 ? position_[row].acceleration() : turn_[row - 3].acceleration();
  }
  bool moving(double time) const noexcept {
    for (int i = 0; i < 3; ++i) {
      if (position_[i].moving(time) || turn_[i].moving(time)) {
        return true;
      }
    }
    return false;
  }
  bool following() const noexcept { return position_[0].following(); }

 private:
  void rebase() noexcept {
    for (int i = 0; i < 9; ++i) {
      base_[i] = rotation_[i];
    }
  }

  /// The turn that remains from the present orientation, which becomes R_0.
  void aim(const double (&to)[9], double (&angles)[3]) noexcept {
    rebase();
    core::orientation_error(rotation_, to, angles);
    for (int i = 0; i < 9; ++i) {
      goal_rotation_[i] = to[i];
    }
  }

  void remember_goal() noexcept {
    const double angles[3] = {turn_[0].target(), turn_[1].target(), turn_[2].target()};
    apply_turn(angles, goal_rotation_);
  }

  void apply_turn(const double (&angles)[3], double (&out)[9]) const noexcept {
    double turn[9];
    core::rotation_from_vector(angles, turn);
    double product[9];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        product[3 * i + j] = turn[3 * i] * base_[j] + turn[3 * i + 1] * base_[3 + j] +
                             turn[3 * i + 2] * base_[6 + j];
      }
    }
    for (int i = 0; i < 9; ++i) {
      out[i] = product[i];
    }
  }

  SmoothNumber position_[3];
  SmoothNumber turn_[3];
  double base_[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  double rotation_[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  double goal_rotation_[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
};

}  // namespace treeline::drive
