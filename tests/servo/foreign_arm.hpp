#pragma once
// Arms as a loop knows them, and as they are: with payloads of which it knows nothing.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "controller/safe_state/plant.hpp"
#include "fr3_plant.hpp"
#include "fr3_plant_joints.hpp"
#include "puma_plant.hpp"
#include "puma_plant_joints.hpp"
#include "servo/safety.hpp"
#include "ur10e_plant.hpp"
#include "ur10e_plant_joints.hpp"

namespace treeline::test {

using tests::Imperfection;

/// The generated functions of an arm that carries nothing.
template <int n, auto InverseDynamics, auto ForwardDynamics>
struct Unloaded {
  static constexpr int kCoordinates = n;
  static constexpr int kVelocities = n;
  static void inverse_dynamics(const double (&q)[n], const double (&qd)[n], const double (&qdd)[n],
                               double (&tau)[n]) noexcept {
    const double nothing[10] = {};
    InverseDynamics(q, qd, qdd, nothing, tau);
  }
  static void forward_dynamics(const double (&q)[n], const double (&qd)[n], const double (&tau)[n],
                               double (&qdd)[n]) noexcept {
    const double nothing[10] = {};
    ForwardDynamics(q, qd, tau, nothing, qdd);
  }
};

struct Fr3 : Unloaded<7, fr3_plant::inverse_dynamics, fr3_plant::forward_dynamics> {
  static constexpr auto kForward = fr3_plant::forward_dynamics;
  static constexpr std::array<double, 7> kStart = {0, 0, 0, -1.6, 0, 1.8, 0};
  static constexpr std::array<double, 7> kGoal = {0.7, 0.5, -0.6, -0.9, 0.8, 2.6, 1.0};
  static constexpr double kRated = 3;  // kg
  /// What the law carries through a motion without knowing of it.
  static constexpr double kCarried = 1.2;
  static servo::SafetyLimits<7, 7> limits() {
    return servo::limits_of(fr3_plant::kLowerLimits, fr3_plant::kUpperLimits,
                            fr3_plant::kVelocityLimits, fr3_plant::kEffortLimits);
  }
};
struct Ur10e : Unloaded<6, ur10e_plant::inverse_dynamics, ur10e_plant::forward_dynamics> {
  static constexpr auto kForward = ur10e_plant::forward_dynamics;
  static constexpr std::array<double, 6> kStart = {0, -1.6, 1.6, -1.6, -1.6, 0};
  static constexpr std::array<double, 6> kGoal = {0.8, -1.0, 0.9, -1.0, -0.8, 1.0};
  static constexpr double kRated = 10;
  static constexpr double kCarried = 2;
  static servo::SafetyLimits<6, 6> limits() {
    return servo::limits_of(ur10e_plant::kLowerLimits, ur10e_plant::kUpperLimits,
                            ur10e_plant::kVelocityLimits, ur10e_plant::kEffortLimits);
  }
};
struct Puma : Unloaded<6, puma_plant::inverse_dynamics, puma_plant::forward_dynamics> {
  static constexpr auto kForward = puma_plant::forward_dynamics;
  static constexpr std::array<double, 6> kStart = {0.3, -0.9, 0.6, 0.2, 0.8, -0.4};
  static constexpr std::array<double, 6> kGoal = {0.9, -0.4, 0.1, -0.4, 0.3, 0.4};
  static constexpr double kRated = 2.5;
  static constexpr double kCarried = 0.1;
  static servo::SafetyLimits<6, 6> limits() {
    return servo::limits_of(puma_plant::kLowerLimits, puma_plant::kUpperLimits,
                            puma_plant::kVelocityLimits, puma_plant::kEffortLimits);
  }
};

/// What a loop reads of an arm and writes to it, for the loop that `Step` runs in the place of an
/// emitted controller.
template <class F, class Step>
struct LoopAsController {
  static constexpr int kJoints = F::kVelocities;
  struct Config {
    double torque[kJoints] = {};
  };
  struct Input {
    double q[kJoints] = {};
    double qd[kJoints] = {};
    struct {
      int kind = 0;
      int sequence = 0;
    } command;
  };
  struct Output {
    double tau[kJoints] = {};
  };
  using State = Step;
  static void default_config(Config& config) {
    const auto limits = F::limits();
    std::copy(limits.torque.begin(), limits.torque.end(), config.torque);
  }
  static void step(const Config&, State& state, const Input& input, Output& output) {
    state.step(input.q, input.qd, output.tau);
  }
};

template <class F, class Step>
using ForeignArm = tests::Plant<LoopAsController<F, Step>, F::kForward>;

inline std::vector<std::pair<const char*, Imperfection>> ways_to_differ(double payload) {
  Imperfection heavy, light, loaded, late;
  heavy.mass_scale = 1.1;
  light.mass_scale = 0.9;
  loaded.payload = payload;
  late.delay = 2;
  return {{"as modelled", {}},
          {"masses + 10 %", heavy},
          {"masses - 10 %", light},
          {"unknown payload", loaded},
          {"two cycles late", late}};
}

/// Where an arm is when it is told to brake, which it has to be at rest near, within 2 s.
template <class Arm, class Spoil>
void expect_rest(Arm& arm, Spoil&& spoil) {
  constexpr double kReach = 0.05;    // rad, of what holds
  constexpr double kBraking = 0.08;  // s: 1 / (20 / s), and the half of 50 ms until that is reached
  const auto q = arm.q;
  const auto qd = arm.qd;
  auto held = q;
  for (int k = 0; k < 2000; ++k) {
    arm.step(spoil);
    for (int i = 0; i < Arm::n; ++i) {
      ASSERT_LE(std::fabs(arm.output.tau[i]), arm.config.torque[i]) << i;
    }
    if (k == 1000) held = arm.q;
  }
  for (std::size_t i = 0; i < q.size(); ++i) {
    EXPECT_NEAR(arm.q[i], q[i] + kBraking * qd[i], 2 * kReach) << "joint " << i;
    EXPECT_NEAR(arm.q[i], held[i], 0.5 * kReach) << "joint " << i;
  }
  EXPECT_LT(arm.fastest(), 0.02);
}

}  // namespace treeline::test
