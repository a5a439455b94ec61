#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drift.hpp"
#include "experiments.hpp"
#include "interpreter/instances.hpp"
#include "interpreter/object_forward_dynamics.hpp"
#include "oracle/model_from_robot.hpp"
#include "oracle/subject.hpp"
#include "simulation/integrate.hpp"

namespace treeline::stress {
namespace {

using simulation::State;
using simulation::Vector;

constexpr double kStep = 1e-3;  ///< s

struct Motion {
  explicit Motion(const ArmOptions& arm, bool weightless) {
    const Case made = make_arm(arm);
    model = model_from_robot<double>(made.robot, made.scene);
    if (weightless) model.gravity.setZero();
    coordinates = simulation::coordinates_of(model);
    state.q = Vector::Zero(model.nq);
    state.qd = Vector::Zero(model.nv);
    for (int i = 0; i < model.nv; ++i) state.qd(i) = weightless ? 0.5 + 0.3 * std::cos(3.0 * i) : 0;
    if (coordinates.quaternions.empty()) {
      state.q(0) = 0.7;
    } else {
      state.q(coordinates.quaternions.front().quaternion() + 3) = 1;
    }
  }
  [[nodiscard]] simulation::Acceleration acceleration() const {
    return [this](double, const State& at) {
      return Vector(
          interpreter::forward_dynamics<double>(model, at.q, at.qd, Vector::Zero(model.nv)));
    };
  }
  simulation::Model model;
  simulation::Coordinates coordinates;
  State state;
};

using Stepper = void (*)(const simulation::Coordinates&, const simulation::Acceleration&, double,
                         double, State&);

Drift energy_drift(const ArmOptions& arm, bool weightless, int steps, Stepper stepper) {
  Motion motion(arm, weightless);
  const auto acceleration = motion.acceleration();
  const double start = simulation::mechanical_energy(motion.model, motion.state);
  const double size =
      std::max(std::abs(start), 2.0 * arm.links * arm.mass * 9.81 * arm.length * arm.links / 2);
  return run(
      steps,
      [&](int i) { stepper(motion.coordinates, acceleration, i * kStep, kStep, motion.state); },
      [&] {
        return std::abs(simulation::mechanical_energy(motion.model, motion.state) - start) / size;
      });
}

Drift momentum_drift(const ArmOptions& arm, int steps) {
  Motion motion(arm, true);
  const auto acceleration = motion.acceleration();
  const auto start = simulation::momentum(motion.model, motion.state);
  return run(
      steps,
      [&](int i) {
        simulation::step_runge_kutta(motion.coordinates, acceleration, i * kStep, kStep,
                                     motion.state);
      },
      [&] {
        // The angular part is about the world's origin, from which the robot moves away.
        const auto now = simulation::momentum(motion.model, motion.state);
        const double way = 1 + motion.state.q.head<3>().norm();
        return (now - start).norm() / (start.norm() * way);
      });
}

Finding motion(const Effort& effort) {
  const int steps = effort.quick ? 20000 : 1000000;
  ArmOptions pendulum;
  pendulum.links = 2;
  ArmOptions flying;
  flying.links = 3;
  flying.floating = true;
  const Drift runge = energy_drift(pendulum, false, steps, simulation::step_runge_kutta);
  const Drift euler = energy_drift(pendulum, false, steps, simulation::step_semi_implicit_euler);
  const Drift spin = energy_drift(flying, true, steps, simulation::step_runge_kutta);
  const Drift momentum = momentum_drift(flying, steps);
  Finding finding{"motion",
                  "Steps of a millisecond: what should stay and does not",
                  "log10 of the number of steps",
                  "log10 of the drift over the size",
                  runge.at,
                  {{"energy", "swinging arm of two links, Runge-Kutta", runge.y, false},
                   {"energy", "the same, semi-implicit Euler", euler.y, false},
                   {"energy", "flying arm of three links, Runge-Kutta", spin.y, false},
                   {"momentum and angular momentum", "flying arm, Runge-Kutta", momentum.y, false}},
                  {},
                  {}};
  finding.said.push_back(fmt::format(
      "log10 of drift after {} steps: energy {:.1f} (Runge-Kutta), {:.1f} (Euler), flying {:.1f}; "
      "momentum {:.1f}",
      steps, runge.y.back(), euler.y.back(), spin.y.back(), momentum.y.back()));
  // A fourth-order method at 1 ms and 10 rad/s loses about 1e-12 of the energy per step, at worst
  // always with the same sign.
  claim(runge.y.back() < std::log10(steps * 1e-12), "Runge-Kutta's energy drift", finding);
  claim(spin.y.back() < std::log10(steps * 1e-12), "the flying arm's energy drift", finding);
  claim(momentum.y.back() < std::log10(steps * 1e-13), "the momentum's drift", finding);
  claim(euler.y.back() < -2, "Euler's energy stays within a hundredth", finding);
  return finding;
}

/// Two arms of seven links, 1 m apart, that hold one ball and swing with it, with damped joints.
struct HeldBall {
  HeldBall() {
    ArmOptions arm;
    arm.links = 7;
    const Case made = make_arm(arm);
    const auto model = model_from_robot<double>(made.robot, made.scene);
    const auto point = points_from_scene(model, made.scene.operational_points).front();
    chain.robots = {model, model};
    chain.robots[1].bodies[0].p_parent_joint(1) = 1;
    q = Vector::Zero(14);
    for (int i = 0; i < 7; ++i) {
      q(i) = 0.3 + 0.5 * std::cos(2.0 * i);
      q(7 + i) = -0.2 + 0.6 * std::cos(2.0 * i + 0.5);
    }
    interpreter::GraspedObject<double> ball;
    ball.mass = 1;
    ball.inertia = 0.01 * interpreter::Matrix3<double>::Identity();
    ball.grasps = {
        {0, point, interpreter::Matrix3<double>::Identity(), interpreter::Vector3<double>::Zero()},
        {1, point, interpreter::Matrix3<double>::Identity(), interpreter::Vector3<double>::Zero()}};
    chain.objects = {ball};
    // The second hand holds the ball where the first one has brought it.
    const auto held = poses(q, Vector::Zero(14));
    auto& second = chain.objects[0].grasps[1];
    second.R = held[1].R.transpose() * held[0].R;
    second.p = held[1].R.transpose() * (held[0].p - held[1].p);
  }
  [[nodiscard]] std::vector<interpreter::HeldPose<double>> poses(const Vector& at,
                                                                 const Vector& rates) const {
    return interpreter::held_poses<double>(chain, {at.head<7>(), at.tail<7>()},
                                           {rates.head<7>(), rates.tail<7>()})[0];
  }
  interpreter::ClosedChain<double> chain;
  Vector q;
};

/// Distance and angle between the poses that the two hands give the ball.
Drift grasp_drift(const interpreter::Stabilisation<double>& gains, int steps) {
  const HeldBall held;
  const simulation::Coordinates coordinates{14, 14, {}};
  State state{held.q, Vector::Zero(14)};
  const simulation::Acceleration acceleration = [&](double, const State& at) {
    const interpreter::PerRobot<double> rates{at.qd.head<7>(), at.qd.tail<7>()};
    const interpreter::PerRobot<double> damping{-2.0 * rates[0], -2.0 * rates[1]};
    const auto motion = interpreter::object_forward_dynamics<double>(
        held.chain, {at.q.head<7>(), at.q.tail<7>()}, rates, damping, gains);
    Vector qdd(14);
    qdd << motion.qdd[0], motion.qdd[1];
    return qdd;
  };
  return run(
      steps,
      [&](int i) {
        simulation::step_runge_kutta(coordinates, acceleration, i * kStep, kStep, state);
      },
      [&] {
        const auto poses = held.poses(state.q, state.qd);
        return interpreter::grasp_drift(poses[0], poses[1]).pose.norm();
      });
}

Finding grasp(const Effort& effort) {
  const int steps = effort.quick ? 2000 : 1000000;
  const Drift plain = grasp_drift({0, 0}, steps);
  const Drift stabilised = grasp_drift({20, 100}, steps);
  Finding finding{
      "grasp",
      "Two arms swing one ball: steps of a millisecond, Runge-Kutta",
      "log10 of the number of steps",
      "log10 of m and rad",
      plain.at,
      {{"how far the grasps part", "table 7.2 as it stands", plain.y, false},
       {"how far the grasps part", "stabilised, 20/s and 100/s^2", stabilised.y, false}},
      {},
      {}};
  finding.said.push_back(fmt::format("log10 of drift after {} steps: {:.1f}, stabilised {:.1f}",
                                     steps, plain.y.back(), stabilised.y.back()));
  claim(plain.y.back() < (effort.quick ? -6 : -4),
        "the grasps part by less than a micrometre in 2 s, a tenth of a millimetre in 1000 s",
        finding);
  claim(stabilised.y.back() < plain.y.back() + 0.1, "stabilisation does not add drift", finding);
  return finding;
}

}  // namespace

std::vector<Experiment> motion_experiments() {
  return {{"motion", motion}, {"grasp", grasp}};
}

}  // namespace treeline::stress
