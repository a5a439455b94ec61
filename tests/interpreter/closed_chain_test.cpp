#include <gtest/gtest.h>

#include "interpreter/closed_chain_cases.hpp"
#include "interpreter/constrained_forward_dynamics.hpp"

// Closed chains (Chang chapter 7) compared with the dense equations of motion with every
// constraint, and with physics. Would catch: a force with a wrong sign, axes or reference point, an
// internal force that moves the object, a drift that is corrected in the wrong direction, and
// robots that are mixed up.

namespace treeline::tests {
namespace {

using namespace interpreter;  // NOLINT(google-build-using-namespace)

struct NamedChain {
  const char* name;
  ChainOptions options;
};

std::ostream& operator<<(std::ostream& out, const NamedChain& named) {
  return out << named.name;
}

class ClosedChains : public testing::TestWithParam<std::tuple<NamedChain, int>> {
 protected:
  ClosedChains()
      : c_(chain_case(100 + 31 * static_cast<std::uint64_t>(std::get<1>(GetParam())),
                      std::get<0>(GetParam()).options)),
        tolerance_(kAlgebra * c_.condition * Digits50(1000)) {}

  [[nodiscard]] ClosedChainMotion<Digits50> motion(
      const PerRobot50& tau, const Stabilisation<Digits50>& gains = {}) const {
    return object_forward_dynamics<Digits50>(c_.chain, c_.q, c_.qd, tau, gains);
  }
  [[nodiscard]] PerRobot50 control(const Vector50& xdd, const Vector50& internal) const {
    return object_control_torque<Digits50>(c_.chain, c_.q, c_.qd, c_.qdd_0, xdd, internal);
  }
  [[nodiscard]] Vector50 no_correction() const {
    int rows = 0;
    for (const auto& object : c_.chain.objects) rows += 6 * static_cast<int>(object.grasps.size());
    return Vector50::Zero(rows);
  }

  ChainCase c_;
  Digits50 tolerance_;
};

const NamedChain kChains[] = {{"one_hand", {.grasps = {1}}},
                              {"two_hands", {.grasps = {2}}},
                              {"two_hands_floating", {.grasps = {2}, .floating_base = true}},
                              {"two_hands_mimics", {.grasps = {2}, .mimic = 0.15}},
                              {"three_hands", {.grasps = {3}}},
                              {"two_robots", {.grasps = {1, 1}}},
                              {"two_robots_three_hands", {.grasps = {2, 1}}},
                              {"four_robots", {.grasps = {1, 1, 1, 1}}},
                              {"two_objects", {.grasps = {2}, .loose_objects = 1}}};

INSTANTIATE_TEST_SUITE_P(Random, ClosedChains,
                         testing::Combine(testing::ValuesIn(kChains), testing::Range(0, 2)),
                         [](const auto& tested) {
                           return std::string(std::get<0>(tested.param).name) + "_" +
                                  std::to_string(std::get<1>(tested.param));
                         });

// Table 7.2 is the solution of the dense constrained system.
TEST_P(ClosedChains, ForwardDynamicsSolvesTheDenseSystem) {
  const DenseMotion dense = dense_motion(c_, no_correction());
  const auto found = motion(c_.tau);
  EXPECT_LT(relative_error(joined(found.qdd), dense.qdd), tolerance_);
  EXPECT_LT(relative_error(found.xdd_object, dense.xdd), tolerance_);
}

// Drift enters as an acceleration of the constraint, whatever the state.
TEST_P(ClosedChains, StabilisationIsAnAccelerationOfTheConstraint) {
  Rng rng(5);
  for (Vector50& qd : c_.qd) qd += random_entries<Digits50>(rng, static_cast<int>(qd.size()), 1);
  const Stabilisation<Digits50> gains{20, 100};
  const auto poses = held_poses<Digits50>(c_.chain, c_.q, c_.qd);
  const auto asked = interpreter::detail::corrections(poses, gains);
  PerRobot50 correction;
  for (int r = 0; r < static_cast<int>(c_.chain.robots.size()); ++r) {
    correction.push_back(interpreter::detail::of_robot(c_.chain, r, asked));
  }
  const DenseMotion dense = dense_motion(c_, joined(correction));
  const auto found = motion(c_.tau, gains);
  EXPECT_LT(relative_error(joined(found.qdd), dense.qdd), tolerance_);
  EXPECT_LT(relative_error(found.xdd_object, dense.xdd), tolerance_);
}

// The chain stays closed to second order: the relative acceleration of all grasps is zero.
TEST_P(ClosedChains, KeepsTheGraspsTogether) {
  const auto found = motion(c_.tau);
  const Stacked all = stacked(c_.chain, c_.q, c_.qd);
  EXPECT_LT(relative_error(all.J * joined(found.qdd) + all.bias, all.C * found.xdd_object),
            tolerance_);
}

// Action = reaction. The forces of the hands, moved to the object's origin, are those of its motion
// by Newton and Euler about the centre of mass; their reactions together with tau are those of the
// robots' motion.
TEST_P(ClosedChains, ActionIsReaction) {
  const auto found = motion(c_.tau);
  const auto poses = held_poses<Digits50>(c_.chain, c_.q, c_.qd);
  Eigen::Index at = 0;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const auto& object = c_.chain.objects[k];
    const auto& first = poses[k].front();
    const Vector6<Digits50> xdd = found.xdd_object.segment<6>(6 * static_cast<Eigen::Index>(k));
    const Vector3<Digits50> c = first.R * object.com, w = angular(first.v), wd = angular(xdd);
    const Matrix3<Digits50> J = first.R * object.inertia * first.R.transpose();
    const Vector3<Digits50> force =
        object.mass * (linear(xdd) + cross<Digits50>(wd, c) +
                       cross<Digits50>(w, cross<Digits50>(w, c)) - c_.chain.robots[0].gravity);
    const Vector3<Digits50> moment = J * wd + cross<Digits50>(w, J * w);
    Vector3<Digits50> f = Vector3<Digits50>::Zero(), m = Vector3<Digits50>::Zero();
    for (const auto& held : poses[k]) {
      const Vector6<Digits50> hand = found.f_grasp.segment<6>(at);
      f += linear(hand);
      m += angular(hand) + cross<Digits50>(held.to_hand - c, linear(hand));
      at += 6;
    }
    EXPECT_LT(relative_error(f, force), tolerance_);
    EXPECT_LT(relative_error(m, moment), tolerance_);
  }
  std::vector<Eigen::Index> next{0};
  for (std::size_t r = 0; r < c_.chain.robots.size(); ++r) {
    Points50 hands;
    Vector50 reaction(0);
    Eigen::Index index = 0;
    for (const auto& object : c_.chain.objects) {
      for (const auto& grasp : object.grasps) {
        const Vector50 f = found.f_grasp.segment(index, 6);
        index += 6;
        if (grasp.robot != static_cast<int>(r)) continue;
        hands.push_back(grasp.point);
        hands.back().axes = PointAxes::world;
        hands.back().rows.fill(true);
        reaction.conservativeResize(reaction.size() + 6);
        reaction.tail<6>() = -f;
      }
    }
    EXPECT_LT(relative_error(inverse_dynamics<Digits50>(c_.chain.robots[r], c_.q[r], c_.qd[r],
                                                        found.qdd[r], hands, reaction),
                             c_.tau[r]),
              tolerance_);
  }
}

// The rate of change of the energy of robots and objects is the power of the joint forces.
TEST_P(ClosedChains, PowerBalances) {
  const auto found = motion(c_.tau);
  const auto energy = [&](const Digits50& t) {
    Digits50 total = 0;
    PerRobot50 q, qd;
    for (std::size_t r = 0; r < c_.chain.robots.size(); ++r) {
      const Model50& model = c_.chain.robots[r];
      q.push_back(moved(model, c_.q[r], c_.qd[r], t));
      qd.push_back(c_.qd[r] + t * found.qdd[r]);
      total += kinetic_energy(model, q[r], qd[r]) + potential_energy(model, q[r]);
    }
    const auto poses = held_poses<Digits50>(c_.chain, q, qd);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      const auto& first = poses[k].front();
      const auto& object = c_.chain.objects[k];
      const Matrix6<Digits50> I = object_inertia(object, first.R);
      total += Digits50(first.v.dot(Vector6<Digits50>(I * first.v))) / 2;
      total -= object.mass *
               c_.chain.robots[0].gravity.dot(Vector3<Digits50>(first.p + first.R * object.com));
    }
    return Eigen::Matrix<Digits50, 1, 1>(total);
  };
  const Digits50 power = joined(c_.tau).dot(joined(c_.qd));
  const Digits50 size = scale(joined(c_.tau)) * scale(joined(c_.qd)) * scale(joined(found.qdd));
  EXPECT_LT(Digits50(abs(Digits50(derivative(energy)(0) - power))), kDifference * size);
}

// Table 7.1 leads to the commanded accelerations and internal forces, whatever the posture is.
TEST_P(ClosedChains, ControlBringsTheCommandedAccelerationAndInternalForces) {
  const auto found = motion(control(c_.xdd, c_.internal));
  EXPECT_LT(relative_error(found.xdd_object, c_.xdd), tolerance_);
  EXPECT_LT(relative_error(found.internal, c_.internal), tolerance_);
}

// Internal forces neither accelerate an object nor do work: only the forces of the grasps change.
TEST_P(ClosedChains, InternalForcesMoveNothing) {
  const Vector50 none = Vector50::Zero(c_.internal.size());
  const PerRobot50 squeezed = control(c_.xdd, c_.internal), loose = control(c_.xdd, none);
  const auto one = motion(squeezed), other = motion(loose);
  EXPECT_LT(relative_error(joined(one.qdd), joined(other.qdd)), tolerance_);
  EXPECT_LT(relative_error(one.xdd_object, other.xdd_object), tolerance_);
  const Vector50 difference = joined(squeezed) - joined(loose);
  EXPECT_LT(Digits50(abs(Digits50(difference.dot(joined(c_.qd))))),
            tolerance_ * scale(difference) * scale(joined(c_.qd)));
}

// The augmented object (7.1): Lambda xdd + mu + p = C^T Jbar^T tau, summed over the robots.
TEST_P(ClosedChains, AugmentedObjectHasTheSameMotion) {
  const auto object = augmented_object<Digits50>(c_.chain, c_.q, c_.qd);
  const auto found = motion(c_.tau);
  Vector50 F = Vector50::Zero(object.p.size());
  for (std::size_t r = 0; r < c_.chain.robots.size(); ++r) {
    const auto points = object_points(c_.chain, static_cast<int>(r));
    const auto o = explicit_operational_space<Digits50>(c_.chain.robots[r], points, c_.q[r]);
    F += connectivity(c_.chain, static_cast<int>(r)).transpose() * o.Jbar.transpose() * c_.tau[r];
  }
  EXPECT_LT(relative_error(object.Lambda * found.xdd_object + object.mu + object.p, F),
            tolerance_ * scale(object.Lambda));
}

// An object without mass only holds its hands to each other: constraints between the first hand and
// the others, frames in the object's, are all that is left of it.
TEST(ObjectWithoutMass, IsConstraintsBetweenItsHands) {
  for (const int hands : {2, 3}) {
    ChainCase c = chain_case(100, {.grasps = {hands}});
    auto& object = c.chain.objects.front();
    object.mass = 0;
    object.inertia.setZero();
    ConstrainedState<Digits50> state;
    state.q = c.q.front();
    state.qd = c.qd.front();
    state.tau = c.tau.front();
    const auto frames = object_points(c.chain, 0);
    for (std::size_t i = 1; i < frames.size(); ++i) {
      state.loops.frames.push_back({frames[i], frames.front()});
    }
    const auto held = constrained_forward_dynamics<Digits50>(c.chain.robots.front(), {}, state);
    const auto moving = object_forward_dynamics<Digits50>(c.chain, c.q, c.qd, c.tau, {});
    const Vector50 qdd = moving.qdd.front();
    EXPECT_LE(Digits50((held.qdd - qdd).cwiseAbs().maxCoeff()),
              kAlgebra * c.condition * Digits50(1000) * qdd.cwiseAbs().maxCoeff())
        << hands << " hands";
    Vector50 sum = Vector50::Zero(3);  // of the hands' forces on what weighs nothing
    for (int i = 0; i < hands; ++i) sum += moving.f_grasp.segment<3>(6 * i);
    EXPECT_LE(Digits50(sum.cwiseAbs().maxCoeff()),
              kAlgebra * c.condition * Digits50(1000) * moving.f_grasp.cwiseAbs().maxCoeff())
        << hands << " hands";
    EXPECT_GT(moving.f_grasp.cwiseAbs().maxCoeff(), Digits50("0.01"));
  }
}

}  // namespace
}  // namespace treeline::tests
