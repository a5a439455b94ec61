// What holds a joint that its controller knows too little of. Would catch: a spring that swings a
// light joint to and fro, faster and faster, where torques come late or velocities are noisy; one
// that softens for noise alone, and lets a joint of ordinary weight sag.
#include "core/emitted_braking.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <random>

namespace treeline::core {
namespace {

/// One joint, as the controller knows it.
struct OneJoint {
  using Real = double;
  static constexpr int kJoints = 1;
  static constexpr bool kTurns[1] = {false};
  struct Config {
    double period = 1e-3, lower[1] = {-6}, upper[1] = {6}, speed[1] = {10};
    double torque[1] = {20}, torque_rate[1] = {800};
    double brake_damping = 20, hold_frequency = 60, hold_reach = 0.05, rest_speed = 1e-3;
    int blind_ticks = 100;
  };
  struct Input {
    double q[1];
  };
  struct State {
    int posed = 0, braking = 0, blind_ticks = 0, known = 0, cut = 0;
    double sound_q[1] = {}, sound_qd[1] = {}, brake_share = 0, brake_q[1] = {}, brake_qd[1] = {};
    double stand_q[1] = {}, load[1] = {}, tau[1] = {};
    double softness[1] = {}, swing[1] = {}, swing_peak[1] = {}, last_peak[1] = {};
    int swing_ticks[1] = {};
  };
  struct Measured {
    double q[1], qd[1];
    bool lost[1];
  };
  static inline double inertia = 1;
  static void joint_torque(const Input& /*input*/, const Measured& /*at*/, const double (&qdd)[1],
                           double (&tau)[1]) {
    tau[0] = inertia * qdd[0];
  }
};
using Braking = EmittedBraking<OneJoint>;

/// How the joint differs from what its controller knows.
struct Plant {
  double inertia = 1;  ///< kg m^2, that the controller knows
  double load = 0;     ///< kg at 0.05 m, of which it does not
  int delay = 0;       ///< steps
  double encoder = 0;  ///< rad, of a count; velocities are filtered differences
  double speed = 0;    ///< rad/s, in the beginning
};

struct Outcome {
  double fastest = 0;  ///< rad/s, in the third second
  double softness = 0;
};

Outcome hold(const Plant& plant) {
  constexpr double kReach = 0.05, kPeriod = 1e-3;
  OneJoint::inertia = plant.inertia;
  const double moved = plant.inertia + plant.load * kReach * kReach;
  const double weight = plant.load * 9.81 * kReach;
  OneJoint::Config config;
  OneJoint::State state;
  OneJoint::Input input{};
  OneJoint::Measured at{};
  std::deque<double> late(static_cast<std::size_t>(plant.delay), 0.0);
  double q = 0, qd = plant.speed, counted = 0, filtered = plant.speed;
  Outcome outcome;
  for (int step = 0; step < 3000; ++step) {
    input.q[0] = q;
    at.qd[0] = qd;
    if (plant.encoder > 0) {
      const double count = plant.encoder * std::round(q / plant.encoder);
      if (step > 0) filtered += 0.2 * ((count - counted) / kPeriod - filtered);
      input.q[0] = counted = count;
      at.qd[0] = filtered;
    }
    Braking::tl_complete_state(&config, &input, true, &state, &at);
    double tau[1];
    Braking::tl_brake_torque(&config, &input, &at, &state, tau);
    Braking::tl_limit_rate(&config, &state, tau);
    late.push_back(tau[0]);
    for (int part = 0; part < 4; ++part) {
      qd += kPeriod / 4 * (late.front() - weight) / moved;
      q += kPeriod / 4 * qd;
    }
    late.pop_front();
    if (step > 2000) outcome.fastest = std::max(outcome.fastest, std::fabs(qd));
  }
  outcome.softness = state.softness[0];
  return outcome;
}

TEST(EmittedBraking, BringsLightJointsToRest) {
  constexpr unsigned kSeed = 5;
  std::mt19937 rng(kSeed);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 400; ++k) {
    Plant plant;
    plant.inertia = std::pow(10, -4.7 + 2.7 * unit(rng));  // from 2e-5
    plant.load = unit(rng) < 0.5 ? unit(rng) : 0;
    plant.delay = static_cast<int>(3 * unit(rng));
    plant.encoder = unit(rng) < 0.5 ? 5e-5 : 0;
    plant.speed = 9 * unit(rng);
    EXPECT_LT(hold(plant).fastest, 0.05)
        << "seed " << kSeed << " case " << k << ": " << plant.inertia << " kg m^2, " << plant.load
        << " kg, " << plant.delay << " steps, " << plant.encoder << " rad, " << plant.speed
        << " rad/s";
  }
}

TEST(EmittedBraking, StaysFirmWhereNothingSwings) {
  for (const double inertia : {1e-2, 5e-2, 0.2}) {
    for (const double load : {0.0, 1.0, 5.0}) {
      for (const double encoder : {0.0, 5e-5}) {
        for (const double speed : {0.0, 3.0}) {
          EXPECT_EQ(hold({inertia, load, 2, encoder, speed}).softness, 0)
              << inertia << " kg m^2, " << load << " kg, " << encoder << " rad, " << speed;
        }
      }
    }
  }
}

}  // namespace
}  // namespace treeline::core
