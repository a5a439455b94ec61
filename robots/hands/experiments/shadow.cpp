#include "servo/integrate.hpp"
#include "shadow_apart.hpp"
#include "shadow_apart_joints.hpp"
#include "shadow_ball.hpp"
#include "turn_ball_with.hpp"

namespace treeline::experiments {
namespace {

namespace apart = shadow_apart;

struct ShadowHand {
  static constexpr const char* kName = "Shadow";
  static constexpr int kCoordinates = apart::kCoordinates;
  static constexpr int kVelocities = apart::kVelocities;
  static constexpr servo::FloatingJoints<kCoordinates, kVelocities> kFloating = {kCoordinates - 7};
  static constexpr int kFingers = 5;
  static constexpr std::array<double, 5> kTipRadii = {0.0075, 0.0075, 0.0075, 0.0075, 0.009};
  static constexpr double kBallRadius = 0.035;
  /// The thumb presses nearly as much as the four fingers that it faces.
  static constexpr double kShares[kFingers] = {0.6, 0.6, 0.6, 0.6, 1.8};
  /// Tips touch the ball where these shares let forces meet near its middle.
  static constexpr double kStart[kCoordinates] = {
      0.069004, 0.241620, 0.891168, 0.835234, -0.086814, 0.433541, 0.912940, 0.448977, -0.082052,
      0.623664, 1.001188, 0.624309, 0.522927, -0.057509, 0.496796, 0.294836, 1.267545, -0.263411,
      0.518122, 0.027036, 0.413510, 0.764625, 0.064560,  0.023747, 0.347199, 0};
  static constexpr auto& kLowerLimits = apart::kLowerLimits;
  static constexpr auto& kUpperLimits = apart::kUpperLimits;
  static constexpr auto& kVelocityLimits = apart::kVelocityLimits;
  static constexpr auto& kEffortLimits = apart::kEffortLimits;
  static constexpr auto& kCoordinateJoints = apart::kCoordinateJoints;
  static constexpr auto& kVelocityJoints = apart::kVelocityJoints;
  static constexpr auto& forward_kinematics = apart::forward_kinematics;
  static constexpr auto& point_velocity = apart::point_velocity;
  static constexpr auto& mass_matrix = apart::mass_matrix;
  static constexpr auto& forward_dynamics = apart::forward_dynamics;
  static constexpr auto& supported_control_torque = shadow_ball::supported_control_torque;

  /// Hand and ball as if they did not touch.
  static void inverse_dynamics(const double (&q)[kCoordinates], const double (&qd)[kVelocities],
                               const double (&qdd)[kVelocities],
                               double (&tau)[kVelocities]) noexcept {
    const double none[6 * (kFingers + 1)] = {};
    apart::inverse_dynamics(q, qd, qdd, none, tau);
  }
};

}  // namespace

BallPlan plan_of_shadow() {
  BallPlan plan;
  plan.turn = 0.2;
  plan.way = 0.008;
  return plan;
}

BallRun turn_ball_by_shadow(const BallPlan& plan) {
  return BallTurning<ShadowHand>(plan).run();
}

}  // namespace treeline::experiments
