#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/orientation.hpp"
#include "servo/compliant_balls.hpp"
#include "servo/integrate.hpp"
#include "servo/robot_proxy.hpp"

namespace treeline::experiments {

/// A hand and a ball that nothing connects but what fingertips and ball feel where they touch. A
/// proxy of the servo loop. `Hand` has the generated functions of a scene whose points, and
/// external forces in world axes, are the middles of the fingertips and then the ball's; the ball's
/// coordinates come last.
template <class Hand>
class HandWithBall {
 public:
  static constexpr int nq = Hand::kCoordinates;
  static constexpr int nv = Hand::kVelocities;
  static constexpr int kFingers = Hand::kFingers;
  static constexpr int kPoints = kFingers + 1;
  using State = servo::StateOf<Hand>;
  using Contacts = servo::CompliantBalls<kFingers>;
  using Balls = typename Contacts::Balls;
  using Touches = typename Contacts::Touches;

  HandWithBall(const State& state, int substeps, const servo::BallMaterial& material) noexcept
      : state_(state),
        substeps_(substeps),
        contacts_(Hand::kTipRadii, Hand::kBallRadius, material) {}

  /// Fingertips and the ball at a state.
  static servo::MovingBall look(const double (&q)[nq], const double (&qd)[nv],
                                Balls& tips) noexcept {
    double position[3 * kPoints], rotation[9 * kPoints], twist[6 * kPoints];
    Hand::forward_kinematics(q, position, rotation);
    Hand::point_velocity(q, qd, twist);
    servo::MovingBall ball;
    for (std::size_t i = 0; i < kPoints; ++i) {
      servo::MovingBall& moving = i < kFingers ? tips[i] : ball;
      std::copy_n(position + 3 * i, 3, moving.center.begin());
      std::copy_n(twist + 6 * i, 3, moving.velocity.begin());
      std::copy_n(twist + 6 * i + 3, 3, moving.spin.begin());
    }
    return ball;
  }

  bool connected() const noexcept { return true; }
  void read(State& state) const noexcept { state = state_; }
  /// The ball has no motors: what is written for it moves nothing.
  void write(const double (&tau)[nv]) noexcept { std::copy_n(tau, nv - 6, tau_); }
  void pass_time(double seconds) noexcept {
    const auto accelerations_at = [this](const double(&q)[nq], const double(&qd)[nv],
                                         double(&qdd)[nv]) noexcept {
      double f_ext[6 * kPoints];
      feel(q, qd, f_ext);
      Hand::forward_dynamics(q, qd, tau_, f_ext, qdd);
    };
    const double step = seconds / substeps_;
    for (int i = 0; i < substeps_; ++i) {
      servo::integrate_runge_kutta<nq, nv>({nq - 7}, step, accelerations_at, state_);
      Balls tips;
      const servo::MovingBall ball = look(state_.q, state_.qd, tips);
      contacts_.stretch_springs(step, tips, ball);
    }
  }

  Touches touches() const noexcept {
    Balls tips;
    const servo::MovingBall ball = look(state_.q, state_.qd, tips);
    return contacts_.touches(tips, ball);
  }
  /// Way that fingertips have slipped on the ball, all together, m.
  double slipped() const noexcept { return contacts_.slipped(); }

 private:
  /// Forces over moments on the tips and on the ball, about their middles.
  void feel(const double (&q)[nq], const double (&qd)[nv],
            double (&f_ext)[6 * kPoints]) const noexcept {
    Balls tips;
    const servo::MovingBall ball = look(q, qd, tips);
    const Touches touches = contacts_.touches(tips, ball);
    std::fill(std::begin(f_ext), std::end(f_ext), 0.0);
    double* const on_ball = f_ext + 6 * kFingers;
    for (std::size_t i = 0; i < kFingers; ++i) {
      add_force(touches[i], tips[i].center, 1.0, f_ext + 6 * i);
      add_force(touches[i], ball.center, -1.0, on_ball);
    }
  }

  static void add_force(const servo::BallTouch& touch, const std::array<double, 3>& center,
                        double sign, double* f) noexcept {
    double arm[3], force[3], moment[3];
    for (std::size_t k = 0; k < 3; ++k) {
      arm[k] = touch.point[k] - center[k];
      force[k] = sign * touch.force[k];
    }
    core::steps::cross(arm, force, moment);
    for (std::size_t k = 0; k < 3; ++k) {
      f[k] += force[k];
      f[3 + k] += moment[k];
    }
  }

  State state_;
  double tau_[nv] = {};
  int substeps_;
  Contacts contacts_;
};

}  // namespace treeline::experiments
