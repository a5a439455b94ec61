// Balances of constrained motion with every force counted: motors, friction, springs, weight,
// external forces, supports, loops, couplings and contacts that roll, with rows in world axes and
// in those of links that turn. Would catch: held rows that start to move because their axes turn,
// forces of supports in other axes or at another point than their rows, a loop that pushes on one
// side only, and friction or springs whose work the energy does not show. Derivatives are
// differences in 50 digits.
#include <gtest/gtest.h>

#include "interpreter/physics.hpp"
#include "interpreter/supported_cases.hpp"

namespace treeline::tests {
namespace {

using interpreter::PointAxes;
using interpreter::Vector3;
using interpreter::Vector6;

class Balances : public testing::TestWithParam<std::tuple<Standing, PointAxes>> {
 protected:
  Balances() : c_(draw_standing_regular(11, std::get<0>(GetParam()))) {
    for (auto& support : c_.task.constraints) support.axes = std::get<1>(GetParam());
    if (c_.made.scene.base == Base::floating) c_.tau.head<6>().setZero();
    const auto moving = interpreter::constrained_forward_dynamics<Digits50>(
        c_.model, c_.task.constraints,
        {c_.q, c_.qd, c_.tau, {}, 0, 0, c_.task.external_points, c_.task.f_ext, c_.task.loops});
    qdd_ = moving.qdd;
    f_ = moving.f;
  }

  [[nodiscard]] Vector50 held_velocity(const Vector50& q, const Vector50& qd) const {
    return interpreter::detail::held_jacobian<Digits50>(c_.model, c_.task.constraints,
                                                        c_.task.loops, q) *
           qd;
  }
  /// Rate of a figure of the state along the motion.
  template <class F>
  [[nodiscard]] auto rate_of(const F& figure) const {
    return derivative([&](const Digits50& t) {
      return figure(moved(c_.model, c_.q, c_.qd, t), Vector50(c_.qd + t * qdd_));
    });
  }
  /// Force over moment about the world's origin of forces in the rows of points, world axes.
  [[nodiscard]] Vector6<Digits50> wrench(const Points50& points, const Vector50& forces) const {
    const auto poses = interpreter::forward_kinematics<Digits50>(c_.model, points, c_.q);
    Vector6<Digits50> total = Vector6<Digits50>::Zero();
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      Vector6<Digits50> own = Vector6<Digits50>::Zero();
      for (int k = 0; k < 6; ++k) {
        if (points[i].rows[detail::at(k)]) own(k) = forces(row++);
      }
      Vector3<Digits50> force = own.head<3>(), moment = own.tail<3>();
      if (points[i].axes == PointAxes::local) {
        force = poses[i].rotation * force;
        moment = poses[i].rotation * moment;
      }
      total += interpreter::stack<Digits50>(force, moment + poses[i].position.cross(force));
    }
    return total;
  }

  StandingCase c_;
  Vector50 qdd_, f_;
};

class FloatingBalances : public Balances {};

/// On which nothing acts that the points of the task do not list, as ground does on what rolls.
std::vector<Standing> floating() {
  std::vector<Standing> all = standings_and_loops();
  std::erase_if(all, [](const Standing& s) { return !s.floating_base || s.on_world; });
  return all;
}

const auto kBothAxes = testing::Values(PointAxes::world, PointAxes::local);

std::string name_of(const testing::TestParamInfo<std::tuple<Standing, PointAxes>>& tested) {
  const bool local = std::get<1>(tested.param) == PointAxes::local;
  return std::string(std::get<0>(tested.param).name) + (local ? "_local" : "_world");
}

INSTANTIATE_TEST_SUITE_P(Standings, Balances,
                         testing::Combine(testing::ValuesIn(standings_and_loops()), kBothAxes),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Standings, FloatingBalances,
                         testing::Combine(testing::ValuesIn(floating()), kBothAxes), name_of);

TEST_P(Balances, HeldRowsKeepTheirVelocity) {
  const Vector50 rate =
      rate_of([&](const Vector50& q, const Vector50& qd) { return held_velocity(q, qd); });
  EXPECT_LE(rate.size() == 0 ? Digits50(0) : Digits50(rate.cwiseAbs().maxCoeff()),
            kDifference * scale(qdd_) * 1000);
}

// d(T + U)/dt is the power of motors, external forces and held rows less what friction takes.
TEST_P(Balances, EnergyChangesByThePowerOfEveryForce) {
  const auto energy = [&](const Vector50& q, const Vector50& qd) {
    Digits50 total = kinetic_energy(c_.model, q, qd) + potential_energy(c_.model, q);
    for (const auto& body : c_.model.bodies) {
      if (interpreter::velocity_count(body.kind) != 1) continue;
      const Digits50 speed = interpreter::joint_velocity<Digits50>(body, qd)(0);
      const Digits50 stretch = interpreter::joint_position<Digits50>(body, q)(0) - body.rest;
      total += (body.armature * speed * speed + body.stiffness * stretch * stretch) / 2;
    }
    return total;
  };
  Digits50 taken = 0;
  for (const auto& body : c_.model.bodies) {
    if (interpreter::velocity_count(body.kind) != 1) continue;
    const Digits50 speed = interpreter::joint_velocity<Digits50>(body, c_.qd)(0);
    taken += speed * interpreter::friction_force<Digits50>(body, speed);
  }
  const Vector50 pushed =
      interpreter::jacobian<Digits50>(c_.model, c_.task.external_points, c_.q) * c_.qd;
  const Digits50 power =
      c_.tau.dot(c_.qd) + c_.task.f_ext.dot(pushed) + f_.dot(held_velocity(c_.q, c_.qd)) - taken;
  EXPECT_LT(Digits50(abs(power - rate_of(energy))),
            kDifference * scale(qdd_, 1000) * (1 + abs(energy(c_.q, c_.qd))));
}

// What is inside the robot, loops and couplings included, changes no momentum.
TEST_P(FloatingBalances, MomentumChangesByOutsideForcesAlone) {
  Vector6<Digits50> outside =
      wrench(c_.task.constraints, f_) + wrench(c_.task.external_points, c_.task.f_ext);
  const auto k = interpreter::kinematics<Digits50>(c_.model, c_.q, c_.qd);
  for (int i = 0; i < c_.model.size(); ++i) {
    const auto& body = c_.model.body(i);
    const Vector3<Digits50> center = k.p_world[i] + k.R_world[i] * body.com;
    const Vector3<Digits50> weight = body.mass * c_.model.gravity;
    outside += interpreter::stack<Digits50>(weight, center.cross(weight));
  }
  const Vector6<Digits50> rate =
      rate_of([&](const Vector50& q, const Vector50& qd) { return momentum(c_.model, q, qd); });
  EXPECT_LT(Digits50((rate - outside).cwiseAbs().maxCoeff()), kDifference * scale(qdd_) * 1000);
}

}  // namespace
}  // namespace treeline::tests
