#include "allegro_apart.hpp"
#include "allegro_apart_joints.hpp"
#include "allegro_ball.hpp"
#include "servo/integrate.hpp"
#include "turn_ball_with.hpp"

namespace treeline::experiments {
namespace {

namespace apart = allegro_apart;

struct AllegroHand {
  static constexpr const char* kName = "Allegro";
  static constexpr int kCoordinates = apart::kCoordinates;
  static constexpr int kVelocities = apart::kVelocities;
  static constexpr servo::FloatingJoints<kCoordinates, kVelocities> kFloating = {kCoordinates - 7};
  static constexpr int kFingers = 3;
  static constexpr std::array<double, 3> kTipRadii = {0.012, 0.012, 0.012};
  static constexpr double kBallRadius = 0.035;
  /// The thumb presses as much as the two fingers that it faces.
  static constexpr double kShares[kFingers] = {1.0, 1.0, 1.7};
  /// Tips touch the ball where these shares let forces meet near its middle.
  static constexpr double kStart[kCoordinates] = {
      0.042260, 0.810318, 1.024388, 0.400577, 0.176218, 0.576739, 0.859554, 0.558721,
      1.045519, 0.612804, 0.769382, 0.813378, 0.093421, 0.005373, 0.010926, 0};
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
  static constexpr auto& supported_control_torque = allegro_ball::supported_control_torque;

  /// Hand and ball as if they did not touch.
  static void inverse_dynamics(const double (&q)[kCoordinates], const double (&qd)[kVelocities],
                               const double (&qdd)[kVelocities],
                               double (&tau)[kVelocities]) noexcept {
    const double none[6 * (kFingers + 1)] = {};
    apart::inverse_dynamics(q, qd, qdd, none, tau);
  }
};

}  // namespace

BallPlan plan_of_allegro() {
  return {};
}

BallRun turn_ball_by_allegro(const BallPlan& plan) {
  return BallTurning<AllegroHand>(plan).run();
}

}  // namespace treeline::experiments
