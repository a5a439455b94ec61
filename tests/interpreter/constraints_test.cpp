#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <utility>

#include "interpreter/physics.hpp"
#include "interpreter/supported_cases.hpp"

// Would catch: constraints that do not hold, forces that do work against them, torques on joints
// without a motor, tasks that are missed although motors can do them, a posture or forces that are
// not the nearest ones, and two formulations that differ.

namespace treeline::tests {
namespace {

const Digits50 kTight("1e-28");

double size_of(const Vector50& x) {
  return x.size() == 0 ? 0 : static_cast<double>(x.cwiseAbs().maxCoeff());
}

interpreter::ConstrainedState<Digits50> state_of(const StandingCase& c, const Vector50& tau) {
  return {c.q, c.qd, tau, {}, 0, 0, c.task.external_points, c.task.f_ext};
}

class Standings : public testing::TestWithParam<std::tuple<Standing, int>> {
 protected:
  Standings()
      : c_(draw_standing_regular(3 + 37 * static_cast<std::uint64_t>(std::get<1>(GetParam())),
                                 std::get<0>(GetParam()))),
        J_s_(interpreter::jacobian<Digits50>(c_.model, c_.task.constraints, c_.q)) {}

  [[nodiscard]] Vector50 accelerations(const Points50& points, const Vector50& qdd) const {
    return interpreter::point_accelerations<Digits50>(c_.model, points, c_.q, c_.qd, qdd);
  }
  [[nodiscard]] interpreter::SupportedTorque<Digits50> torque() const {
    return interpreter::supported_control_torque<Digits50>(c_.model, c_.task, c_.q, c_.qd);
  }
  [[nodiscard]] interpreter::ConstrainedMotion<Digits50> motion(const Vector50& tau) const {
    return interpreter::constrained_forward_dynamics<Digits50>(c_.model, c_.task.constraints,
                                                               state_of(c_, tau));
  }

  StandingCase c_;
  Matrix50 J_s_;
};

INSTANTIATE_TEST_SUITE_P(Random, Standings,
                         testing::Combine(testing::ValuesIn(standings()), testing::Range(0, 2)),
                         [](const auto& tested) {
                           return std::string(std::get<0>(tested.param).name) + "_" +
                                  std::to_string(std::get<1>(tested.param));
                         });

TEST_P(Standings, ConstraintsHoldAndNewtonsLawDoes) {
  const auto moving = motion(c_.tau);
  const Vector50 held = accelerations(c_.task.constraints, moving.qdd);
  EXPECT_LE(size_of(held), kTight);
  const Vector50 needed = interpreter::inverse_dynamics<Digits50>(
      c_.model, c_.q, c_.qd, moving.qdd, c_.task.external_points, c_.task.f_ext);
  EXPECT_LE(size_of(needed - c_.tau - J_s_.transpose() * moving.f), kTight * size_of(needed));
}

TEST_P(Standings, StabilisationLeadsDriftBack) {
  auto at = state_of(c_, c_.tau);
  at.drift = c_.drift;
  at.damping = 20;
  at.stiffness = 100;
  const auto moving =
      interpreter::constrained_forward_dynamics<Digits50>(c_.model, c_.task.constraints, at);
  const Vector50 wanted = -20 * (J_s_ * c_.qd) - 100 * c_.drift;
  EXPECT_LE(size_of(accelerations(c_.task.constraints, moving.qdd) - wanted), kTight);
}

// Gauss' principle: of all accelerations that hold the rows, the one nearest to the free motion.
TEST_P(Standings, ForcesDoNoWorkOnMotionsThatAreFree) {
  const auto moving = motion(c_.tau);
  const Vector50 free = interpreter::forward_dynamics<Digits50>(
      c_.model, c_.q, c_.qd, c_.tau, c_.task.external_points, c_.task.f_ext);
  const Matrix50 M = interpreter::mass_matrix<Digits50>(c_.model, c_.q);
  const Vector50 change = M * (moving.qdd - free);
  Rng rng(9);
  Vector50 motion = random_entries<Digits50>(rng, c_.model.nv, 1);
  if (J_s_.rows() > 0) {
    motion -=
        J_s_.transpose() *
        interpreter::inverse_of_positive_definite<Digits50>(Matrix50(J_s_ * J_s_.transpose())) *
        (J_s_ * motion);
  }
  EXPECT_LE(size_of(Vector50::Constant(1, motion.dot(change))), kTight * (1 + size_of(change)));
}

TEST_P(Standings, MotorsAloneDoTheTask) {
  const auto torque = this->torque();
  for (const int v : c_.task.passive) EXPECT_EQ(torque.tau(v), Digits50(0));
  const auto moving = motion(torque.tau);
  EXPECT_LE(size_of(accelerations(c_.task.points, moving.qdd) - c_.task.xdd_cmd), kTight);
  // The forces that were chosen are those that then act: with independent constraints no others
  // can.
  EXPECT_LE(size_of(moving.f - torque.f), kTight * (1 + size_of(torque.f)));
}

// With the motion's own acceleration as task and posture, and its forces as those wanted, the
// torques are those that caused the motion.
TEST_P(Standings, TorqueThatWasGivenComesBack) {
  Vector50 tau = c_.tau;
  for (const int v : c_.task.passive) tau(v) = 0;
  const auto moving = motion(tau);
  auto task = c_.task;
  task.qdd_0 = moving.qdd;
  task.xdd_cmd = accelerations(task.points, moving.qdd);
  task.f_wanted = moving.f;
  const auto torque = interpreter::supported_control_torque<Digits50>(c_.model, task, c_.q, c_.qd);
  EXPECT_LE(size_of(torque.tau - tau), kTight * (1 + size_of(tau) + size_of(moving.f)));
}

// What is changed along motions that motors can make without moving task or constraints must cost:
// the distance to the posture is least, in the metric of M.
TEST_P(Standings, PostureIsTheNearest) {
  const auto best = motion(torque().tau);
  const Matrix50 M = interpreter::mass_matrix<Digits50>(c_.model, c_.q);
  Rng rng(11);
  auto other = c_.task;
  other.qdd_0 += random_entries<Digits50>(rng, c_.model.nv, 3);
  const auto next =
      motion(interpreter::supported_control_torque<Digits50>(c_.model, other, c_.q, c_.qd).tau);
  const Vector50 change = next.qdd - best.qdd;
  const Vector50 off = best.qdd - c_.task.qdd_0;
  EXPECT_LE(size_of(Vector50::Constant(1, change.dot(M * off))),
            kTight * (1 + size_of(M * off)) * (1 + size_of(change)));
}

TEST_P(Standings, ForcesAreTheNearestThatCarryTheMotion) {
  const auto torque = this->torque();
  if (torque.f.size() == 0) return;
  const Vector50 weights = interpreter::detail::force_weights<Digits50>(c_.task.constraints);
  // Forces that passive joints do not feel: what motors can change.
  Rng rng(13);
  Vector50 internal = random_entries<Digits50>(rng, static_cast<int>(torque.f.size()), 1);
  if (!c_.task.passive.empty()) {
    const Matrix50 J_sp = J_s_(Eigen::all, c_.task.passive);
    internal -= interpreter::detail::solve_consistent<Digits50>(
        Matrix50(J_sp.transpose()), Vector50(J_sp.transpose() * internal));
  }
  const Vector50 off = (torque.f - c_.task.f_wanted).cwiseQuotient(weights);
  EXPECT_LE(size_of(Vector50::Constant(1, internal.dot(off))), kTight * (1 + size_of(off)));
}

// A second hold of the same link adds rows that depend on others: forces are ambiguous, the
// acceleration is not.
TEST(RedundantConstraints, LeaveTheAccelerationUnique) {
  const StandingCase c = draw_standing_regular(3, standings().front());
  auto twice = c.task.constraints;
  twice.push_back(twice.front());
  twice.back().rows = kPointFoot;
  const auto once = interpreter::constrained_forward_dynamics<Digits50>(c.model, c.task.constraints,
                                                                        state_of(c, c.tau));
  const auto again =
      interpreter::constrained_forward_dynamics<Digits50>(c.model, twice, state_of(c, c.tau));
  EXPECT_LE(size_of(once.qdd - again.qdd), kTight * size_of(once.qdd));
  interpreter::TaskLaw<Digits50> law;
  law.power = 6;
  law.borders.assign(9, Digits50("1e-6"));
  const auto relaxed =
      interpreter::constrained_forward_dynamics<Digits50>(c.model, twice, state_of(c, c.tau), law);
  EXPECT_LE(size_of(once.qdd - relaxed.qdd), Digits50("1e-18") * size_of(once.qdd));
}

/// A robot on point feet that falls and swings without drive, in double.
struct Swing {
  interpreter::Model<double> model;
  interpreter::Points<double> feet;
  interpreter::Vector<double> q, qd;
};

Swing draw_swing() {
  const StandingCase c = draw_standing_regular(3, standings()[2]);
  Swing swing{interpreter::cast<double>(c.model), interpreter::cast<double>(c.task.constraints),
              c.q.unaryExpr([](const Digits50& x) { return static_cast<double>(x); }),
              c.qd.unaryExpr([](const Digits50& x) { return static_cast<double>(x); })};
  for (auto& foot : swing.feet) foot.axes = interpreter::PointAxes::world;
  const Eigen::MatrixXd J = interpreter::jacobian<double>(swing.model, swing.feet, swing.q);
  swing.qd -= J.completeOrthogonalDecomposition().solve(Eigen::VectorXd(J * swing.qd));
  return swing;
}

/// One step of the classical Runge-Kutta method.
void advance(Swing& swing, double dt) {
  const interpreter::Vector<double> none = interpreter::Vector<double>::Zero(swing.model.nv);
  interpreter::Vector<double> rates = interpreter::Vector<double>::Zero(swing.model.nq);
  interpreter::Vector<double> qdd = none, q_sum = swing.q, qd_sum = swing.qd;
  const double fractions[] = {0, 0.5, 0.5, 1}, weights[] = {1. / 6, 1. / 3, 1. / 3, 1. / 6};
  for (int stage = 0; stage < 4; ++stage) {
    const interpreter::Vector<double> q = swing.q + fractions[stage] * dt * rates;
    const interpreter::Vector<double> qd = swing.qd + fractions[stage] * dt * qdd;
    rates = interpreter::position_derivative<double>(swing.model, q, qd);
    qdd = interpreter::constrained_forward_dynamics<double>(swing.model, swing.feet,
                                                            {q, qd, none, {}})
              .qdd;
    q_sum += weights[stage] * dt * rates;
    qd_sum += weights[stage] * dt * qdd;
  }
  swing.q = q_sum;
  swing.qd = qd_sum;
}

double energy_of(const Swing& swing) {
  return interpreter::kinetic_energy<double>(swing.model, swing.q, swing.qd) +
         interpreter::potential_energy<double>(swing.model, swing.q);
}

// Constraints do no work. What is left is the integrator's error, of fifth order in its step.
TEST(ConstrainedMotion, KeepsEnergyAndPlaces) {
  const auto run = [](double dt) {
    Swing swing = draw_swing();
    const double kinetic = interpreter::kinetic_energy<double>(swing.model, swing.q, swing.qd);
    const double energy = energy_of(swing);
    const auto places = interpreter::forward_kinematics<double>(swing.model, swing.feet, swing.q);
    const int steps = static_cast<int>(std::lround(0.1 / dt));
    for (int step = 0; step < steps; ++step) advance(swing, dt);
    const auto now = interpreter::forward_kinematics<double>(swing.model, swing.feet, swing.q);
    double drift = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      drift = std::max(drift, (now[i].position - places[i].position).norm());
    }
    return std::pair{std::abs(energy_of(swing) - energy) / kinetic, drift};
  };
  const auto [coarse, coarse_drift] = run(1e-3);
  const auto [fine, fine_drift] = run(5e-4);
  std::cout << "energy off by " << coarse << " and " << fine << ", feet by " << coarse_drift
            << " and " << fine_drift << " m\n";
  EXPECT_LE(fine, std::max(1e-12, coarse / 8));
  EXPECT_LE(fine_drift, std::max(1e-13, coarse_drift / 8));
  EXPECT_LE(coarse, 1e-5);
  EXPECT_LE(coarse_drift, 1e-5);
}

}  // namespace
}  // namespace treeline::tests
