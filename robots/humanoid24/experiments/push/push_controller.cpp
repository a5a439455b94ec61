#include "push_controller.hpp"

#include <algorithm>
#include <cmath>

#include "core/command_laws.hpp"
#include "core/ldlt.hpp"
#include "core/posture_laws.hpp"

namespace treeline::experiments {
namespace {

namespace robot = humanoid24_push;
constexpr int kRates = robot::kVelocities;
static_assert(kRates == 30 && robot::kTaskRows == 3);

constexpr PushTimes kTimes;
constexpr double kLean = 0.45;                   ///< of the waist to either side, rad
constexpr double kReach[3] = {0.4, 0.05, -0.1};  ///< way of the hand, m
constexpr double kWeight = 75.0 * 9.81;          ///< N (README.md)
constexpr double kWidth = 0.18;                  ///< between the middles of the feet, m
constexpr double kInset = 0.1;                   ///< of the law of balance from toes and heels, m
constexpr core::Gains<double> kHand{400.0, 40.0}, kBalance{200.0, 28.0};
constexpr int kJoints = kRates - 6;
constexpr int kAnkle = 0, kHip = 2, kWaistRoll = 5,
              kNeck = 20;  ///< joints in the generated code's order

/// Gains of the posture's springs: weak in the legs, which balance, strong in light joints.
constexpr core::Gains<double> gains_of(int joint) noexcept {
  if (joint <= kHip) return {25.0, 10.0};
  if (joint <= kWaistRoll) return {60.0, 16.0};
  return joint < kNeck ? core::Gains<double>{400.0, 40.0} : core::Gains<double>{2500.0, 100.0};
}

/// The state as the controller takes it: soles flat on the ground where they were put. What the
/// soles turn, the ankle is taken to turn, as if its encoder were on the ground: so it is the calf
/// that the ankle holds upright, and not the light soles, which rock on the ground.
HumanoidState on_flat_soles(const HumanoidState& state, const HumanoidState& start) noexcept {
  HumanoidState flat = state;
  std::copy_n(start.q, 7, flat.q);
  std::fill_n(flat.qd, 6, 0.0);
  flat.q[7 + kAnkle] += 2.0 * std::asin(state.q[4]);
  flat.qd[6 + kAnkle] += state.qd[4];
  return flat;
}

}  // namespace

double lean_at(double time) noexcept {
  if (time >= kTimes.lean_end) return 0.0;
  const double turn = 2.0 * std::acos(-1.0) * time / kTimes.lean_end;
  return kLean * std::sin(turn) * 0.5 * (1.0 - std::cos(2.0 * turn));
}

void PushController::start(double time, const HumanoidState& state) noexcept {
  begin_ = time;
  start_ = state;
  double from[3], rotation[9], to[3];
  robot::forward_kinematics(state.q, from, rotation);
  for (int i = 0; i < 3; ++i) to[i] = from[i] + kReach[i];
  out_ = core::rest_to_rest<3>(from, to, kTimes.hold - kTimes.reach);
  back_ = core::rest_to_rest<3>(to, from, kTimes.rest - kTimes.back);
}

void PushController::apply(double, const servo::Message&) noexcept {}

/// Tracks the path of the hand.
void PushController::ask_hand(double time, const HumanoidState& state,
                              double (&xdd_cmd)[3]) noexcept {
  double position[3], rotation[9], J[3 * kRates], error[3];
  double velocity[3] = {};
  robot::forward_kinematics(state.q, position, rotation);
  robot::jacobian(state.q, J);
  const auto wanted =
      time < kTimes.back ? out_.at(time - kTimes.reach) : back_.at(time - kTimes.back);
  for (int i = 0; i < 3; ++i) {
    error[i] = wanted.position[i] - position[i];
    for (int k = 0; k < kRates; ++k) velocity[i] += J[i * kRates + k] * state.qd[k];
  }
  core::tracking_law<3, double>(kHand, error, velocity, wanted.velocity, wanted.acceleration,
                                xdd_cmd);
  hand_error_ = std::hypot(error[0], error[1], error[2]);
}

/// The posture of the start, leaning, by springs and dampers that turn joints against a base that
/// stands still, M^-1 (K (wanted - q) - D qd): they have a potential, so that the body comes to
/// rest. K is the stiffness times M_ii. Besides, the centre of mass stays well within the feet.
void PushController::advise(double time, const HumanoidState& state,
                            double (&qdd_0)[kRates]) noexcept {
  double M[kRates * kRates], of_joints[kJoints * kJoints], spring[kJoints];
  robot::mass_matrix(state.q, M);
  for (int i = 0; i < kJoints; ++i) {
    const core::Gains<double> gains = gains_of(i);
    const double wanted = start_.q[7 + i] + (i == kWaistRoll ? lean_at(time) : 0.0);
    const double* const row = M + (6 + i) * kRates + 6;
    std::copy_n(row, kJoints, of_joints + i * kJoints);
    spring[i] = row[i] * (gains.kp * (wanted - state.q[7 + i]) - gains.kv * state.qd[6 + i]);
  }
  core::ldlt_factor<kJoints>(of_joints);
  core::ldlt_solve(of_joints, spring);
  std::copy_n(spring, kJoints, qdd_0 + 6);
  double J_com[3 * kRates];
  robot::center_of_mass(state.q, com_);
  robot::center_of_mass_jacobian(state.q, J_com);
  // Legs of this body move it forward only; to the sides the waist's spring is enough.
  double forward[2 * kRates] = {};
  std::copy_n(J_com + 6, kJoints, forward + 6);
  const double com[2] = {com_[0], com_[1]};
  const double goal[2] = {
      std::clamp(com_[0], HumanoidOnSoles::kHeel + kInset, HumanoidOnSoles::kToe - kInset),
      com_[1]};
  core::add_balance(kBalance, goal, com, forward, 0.01, state.qd, qdd_0);
}

void PushController::control(double time, const HumanoidState& measured,
                             double (&tau)[kRates]) noexcept {
  const HumanoidState state = on_flat_soles(measured, start_);
  const double since = time - begin_;
  double xdd_cmd[3];
  double qdd_0[kRates] = {};
  ask_hand(since, state, xdd_cmd);
  advise(since, state, qdd_0);
  double f_wanted[kHeldRows] = {};
  const double share = std::clamp(0.5 + com_[1] / kWidth, 0.0, 1.0);
  f_wanted[2] = kWeight * share;
  f_wanted[8] = kWeight * (1.0 - share);
  if (within_limits_) {
    robot::limited_control_torque(state.q, state.qd, qdd_0, xdd_cmd, f_wanted, tau, f_, limited_);
  } else {
    robot::supported_control_torque(state.q, state.qd, qdd_0, xdd_cmd, f_wanted, tau, f_);
  }
}

}  // namespace treeline::experiments
