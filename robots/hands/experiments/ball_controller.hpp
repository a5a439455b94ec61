#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "ball_plan.hpp"
#include "core/command_laws.hpp"
#include "core/orientation.hpp"
#include "hand_with_ball.hpp"
#include "servo/message.hpp"
#include "servo/spring_posture.hpp"

namespace treeline::experiments {

/// Forces of the ball on the fingertips that a cycle chose.
struct Grip {
  double least_pressure = 0.0;  ///< along the normal, of all fingers, N
  double friction = 0.0;        ///< largest share of the tangential in the normal force
  double away = 0.0;            ///< of the ball from its path, m
  double turned_away = 0.0;     ///< rad
};

/// Turns and leads the ball by the `supported_control_torque` of a scene whose fingertips roll on
/// it: the ball is the task, its squeeze the forces that are wanted, the fingers' posture is that
/// of the start. Contacts are taken to hold.
template <class Hand>
class BallController {
 public:
  static constexpr int nq = Hand::kCoordinates;
  static constexpr int nv = Hand::kVelocities;
  static constexpr int kFingers = Hand::kFingers;
  static constexpr int kJoints = nv - 6;
  static constexpr int kHeld = 3 * kFingers;
  using Plant = HandWithBall<Hand>;
  using State = servo::StateOf<Hand>;

  explicit BallController(const BallPlan& plan) noexcept : plan_(plan) {}

  void start(double time, const State& state) noexcept {
    begin_ = time;
    start_ = state;
    rotation_of(state, start_rotation_);
  }
  void apply(double, const servo::Message&) noexcept {}

  void control(double time, const State& state, double (&tau)[nv]) noexcept {
    typename Plant::Balls tips;
    const servo::MovingBall ball = Plant::look(state.q, state.qd, tips);
    double R[9], xdd[6], f_wanted[kHeld], f[kHeld], qdd_0[nv] = {};
    rotation_of(state, R);
    ask_ball(time - begin_, ball, R, xdd);
    squeeze(tips, ball, R, f_wanted);
    advise(state, qdd_0);
    Hand::supported_control_torque(state.q, state.qd, qdd_0, xdd, f_wanted, tau, f);
    look_at_forces(tips, ball, R, f);
  }

  const Grip& grip() const noexcept { return grip_; }

 private:
  static constexpr core::Gains<double> kBall{900.0, 60.0};
  static constexpr servo::SpringSettings kSprings{0.5, 1.0, 0.1, 0.2, 0.001};

  static void rotation_of(const State& state, double (&R)[9]) noexcept {
    const double* const q = state.q + nq - 4;
    const double quaternion[4] = {q[0], q[1], q[2], q[3]};
    core::rotation_from_quaternion(quaternion, R);
  }

  /// The joints of the hand alone, as springs hold them: its block of M, which no ball couples.
  struct Fingers {
    static constexpr int kCoordinates = kJoints;
    static constexpr int kVelocities = kJoints;
    static void mass_matrix(const double (&joints)[kJoints],
                            double (&M)[kJoints * kJoints]) noexcept {
      double q[nq] = {}, all[nv * nv];
      std::copy_n(joints, kJoints, q);
      q[nq - 1] = 1.0;
      Hand::mass_matrix(q, all);
      for (int row = 0; row < kJoints; ++row) {
        std::copy_n(all + row * nv, kJoints, M + row * kJoints);
      }
    }
  };

  static servo::SpringPosture<Fingers> springs() noexcept {
    double lower[kJoints], upper[kJoints];
    std::copy_n(Hand::kLowerLimits, kJoints, lower);
    std::copy_n(Hand::kUpperLimits, kJoints, upper);
    return {kSprings, lower, upper};
  }

  /// Fingers stay as they were where the ball lets them, and off their limits.
  void advise(const State& state, double (&qdd_0)[nv]) const noexcept {
    servo::RobotState<kJoints, kJoints> fingers;
    double advised[kJoints], qdd[kJoints];
    std::copy_n(state.q, kJoints, fingers.q);
    std::copy_n(state.qd, kJoints, fingers.qd);
    std::copy_n(start_.q, kJoints, advised);
    springs_.advise(fingers, advised, qdd);
    std::copy_n(qdd, kJoints, qdd_0);
  }

  /// Legs of the plan turn about one axis each, so that rates of the rotation vector are spins.
  void ask_ball(double time, const servo::MovingBall& ball, const double (&R)[9],
                double (&xdd)[6]) noexcept {
    const auto wanted = ball_at(plan_, time);
    const double turn[3] = {wanted.position[3], wanted.position[4], wanted.position[5]};
    double turned[9], R_wanted[9] = {}, position[3], goal[3], error[6], velocity[6];
    core::rotation_from_vector(turn, turned);
    for (int i = 0; i < 9; ++i) {
      for (int k = 0; k < 3; ++k) {
        R_wanted[i] += turned[3 * (i / 3) + k] * start_rotation_[3 * k + i % 3];
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      position[i] = ball.center[i];
      goal[i] = start_.q[nq - 7 + static_cast<int>(i)] + wanted.position[i];
      velocity[i] = ball.velocity[i];
      velocity[3 + i] = ball.spin[i];
    }
    core::pose_error(position, R, goal, R_wanted, error);
    core::tracking_law(kBall, error, velocity, wanted.velocity, wanted.acceleration, xdd);
    grip_.away = std::hypot(error[0], error[1], error[2]);
    grip_.turned_away = std::hypot(error[3], error[4], error[5]);
  }

  static std::array<double, 3> normal_of(const servo::MovingBall& tip,
                                         const servo::MovingBall& ball) noexcept {
    std::array<double, 3> normal;
    double square = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      normal[k] = tip.center[k] - ball.center[k];
      square += normal[k] * normal[k];
    }
    for (double& entry : normal) entry /= std::sqrt(square);
    return normal;
  }

  /// Forces on the tips away from the weighted middle of the contacts: whatever the contacts, they
  /// balance each other and turn nothing. In the ball's axes, as the scene's rows are.
  void squeeze(const typename Plant::Balls& tips, const servo::MovingBall& ball,
               const double (&R)[9], double (&f_wanted)[kHeld]) const noexcept {
    double middle[3] = {}, all = 0.0;
    std::array<std::array<double, 3>, kFingers> normals;
    for (std::size_t i = 0; i < kFingers; ++i) {
      normals[i] = normal_of(tips[i], ball);
      for (std::size_t k = 0; k < 3; ++k) middle[k] += Hand::kShares[i] * normals[i][k];
      all += Hand::kShares[i];
    }
    for (std::size_t i = 0; i < kFingers; ++i) {
      for (std::size_t row = 0; row < 3; ++row) {
        double& force = f_wanted[3 * i + row];
        force = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
          force +=
              plan_.squeeze * Hand::kShares[i] * R[3 * k + row] * (normals[i][k] - middle[k] / all);
        }
      }
    }
  }

  void look_at_forces(const typename Plant::Balls& tips, const servo::MovingBall& ball,
                      const double (&R)[9], const double (&f)[kHeld]) noexcept {
    grip_.least_pressure = 1e9;
    grip_.friction = 0.0;
    for (std::size_t i = 0; i < kFingers; ++i) {
      const std::array<double, 3> normal = normal_of(tips[i], ball);
      double pressure = 0.0, square = 0.0;
      for (std::size_t row = 0; row < 3; ++row) {
        const double force = f[3 * i + row];
        for (std::size_t k = 0; k < 3; ++k) pressure += R[3 * k + row] * normal[k] * force;
        square += force * force;
      }
      const double across = std::sqrt(std::max(0.0, square - pressure * pressure));
      grip_.least_pressure = std::min(grip_.least_pressure, pressure);
      grip_.friction = std::max(grip_.friction, pressure > 0.0 ? across / pressure : 1e9);
    }
  }

  BallPlan plan_;
  double begin_ = 0.0;
  State start_{};
  servo::SpringPosture<Fingers> springs_ = springs();
  double start_rotation_[9] = {};
  Grip grip_;
};

}  // namespace treeline::experiments
