// Two robots with one object on generated code (Chang 7.2.2): the claims of the run, and the pair's
// control and motion compared with the interpreter's closed chain of both robots in 50 digits.
// Would catch: a frame, sign or order that is right for one robot and wrong for two.
#include "carry_object.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "description/read_urdf.hpp"
#include "interpreter/instances.hpp"
#include "oracle/model_from_robot.hpp"

namespace {

using namespace treeline;               // NOLINT: all of it is under test
using namespace treeline::experiments;  // NOLINT: all of it is under test
namespace ip = treeline::interpreter;
using ip::Digits50;

Robot samm() {
  Diagnostics diagnostics;
  const auto robot = read_urdf(TREELINE_ROBOTS_DIR "/samm/samm.urdf", diagnostics);
  EXPECT_TRUE(robot);
  return robot.value_or(Robot{});
}

const CarryOutcome& the_run() {
  static const CarryOutcome outcome = carry_object({});
  return outcome;
}

TEST(CarryObject, FollowsTheCircleSqueezedAsCommanded) {
  const CarryOutcome& outcome = the_run();
  ASSERT_EQ(outcome.table.rows(), 10001U);
  const CarryErrors errors = largest_errors(outcome);
  EXPECT_TRUE(within_bounds(outcome)) << summary(outcome);
  EXPECT_GT(errors.travel, 0.5);  // the bases go along
}

TEST(CarryObject, StaysWithinTheRobotsLimits) {
  const report::Table& table = the_run().table;
  const Robot robot = samm();
  int joint_number = 0;
  for (const Joint& joint : robot.joints) {
    if (joint.type == JointType::fixed || !joint.limits) {
      continue;
    }
    ++joint_number;
    for (const char* which : {"first/", "second/"}) {
      const auto column = [&](const char* quantity) {
        const auto& names = table.names();
        const std::string name = quantity + (which + joint.name);
        return table.column(
            static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin()));
      };
      for (const double q : column("q_")) {
        ASSERT_TRUE(q > joint.limits->lower && q < joint.limits->upper) << joint.name;
      }
      for (const double tau : column("tau_")) {
        ASSERT_LT(std::abs(tau), joint.limits->effort) << joint.name;
      }
    }
  }
  EXPECT_EQ(joint_number, kJoints);
}

/// Both robots and the beam in the interpreter's types.
ip::ClosedChain<Digits50> the_chain() {
  const Robot robot = samm();
  const auto model = model_from_robot<Digits50>(robot, {});
  ip::ClosedChain<Digits50> chain;
  chain.robots = {model, model};
  ip::GraspedObject<Digits50> object;
  object.mass = 8;
  object.com << Digits50(0.05), 0, 0;
  object.inertia.diagonal() << Digits50(0.0133), Digits50(0.433), Digits50(0.433);
  ip::OperationalPoint<Digits50> flange;
  for (int i = 0; i < model.size(); ++i) {
    flange.body = model.body(i).name == "tool" ? i : flange.body;
  }
  for (int which = 0; which < 2; ++which) {
    ip::Grasp<Digits50> grasp;
    grasp.robot = which;
    grasp.point = flange;
    grasp.p << 0, 0, Digits50(0.4);
    const int side = which == 0 ? 1 : -1;
    grasp.R << 0, 0, -1, 0, side, 0, side, 0, 0;
    object.grasps.push_back(grasp);
  }
  chain.objects = {object};
  return chain;
}

ip::Vector<Digits50> vector(const double* values, int count) {
  ip::Vector<Digits50> result(count);
  for (int i = 0; i < count; ++i) {
    result(i) = values[i];
  }
  return result;
}

template <int N>
void expect_near(const double (&actual)[N], const ip::Vector<Digits50>& expected) {
  // 20 ulp times the condition number of Lambda, 5e5: a wrist without motors on a base of 150 kg.
  const double scale = 2e-9 * (1 + static_cast<double>(expected.cwiseAbs().maxCoeff()));
  for (int i = 0; i < N; ++i) {
    EXPECT_NEAR(actual[i], static_cast<double>(expected(i)), scale) << i;
  }
}

TEST(CarryObject, PairIsTheInterpretersClosedChain) {
  const report::Table& table = the_run().table;
  const auto chain = the_chain();
  const auto& names = table.names();
  const auto first = static_cast<std::size_t>(
      std::find(names.begin(), names.end(), "q_first/base_x") - names.begin());
  for (const std::size_t row : {0U, 3456U, 6543U}) {
    PairState state;
    double qdd_0[2][kJoints];
    for (std::size_t which = 0; which < 2; ++which) {
      for (std::size_t i = 0; i < kJoints; ++i) {
        state.q[which][i] = table.at(row, first + which * kJoints + i);
        state.qd[which][i] = 0.3 * std::sin(static_cast<double>(row + 3 * i + which));
        qdd_0[which][i] = std::cos(static_cast<double>(row + i + 5 * which));
      }
    }
    const double xdd[6] = {0.5, -1, 2, 0.3, -0.4, 0.7};
    const double internal[6] = {-30, 2, 1, -0.5, 0.2, 0.1};
    const ip::PerRobot<Digits50> q{vector(state.q[0], kJoints), vector(state.q[1], kJoints)};
    const ip::PerRobot<Digits50> qd{vector(state.qd[0], kJoints), vector(state.qd[1], kJoints)};
    const ip::PerRobot<Digits50> posture{vector(qdd_0[0], kJoints), vector(qdd_0[1], kJoints)};
    const PairTorques torques = control_pair(state, xdd, internal, qdd_0);
    const auto tau = ip::object_control_torque<Digits50>(chain, q, qd, posture, vector(xdd, 6),
                                                         vector(internal, 6));
    const PairMotion motion = move_pair(state, torques);
    const auto moved = ip::object_forward_dynamics<Digits50>(
        chain, q, qd, {vector(torques.tau[0], kJoints), vector(torques.tau[1], kJoints)},
        {Digits50(100), Digits50(2500)});
    for (std::size_t which = 0; which < 2; ++which) {
      expect_near(torques.tau[which], tau[which]);
      expect_near(motion.qdd[which], moved.qdd[which]);
    }
    expect_near(motion.xdd, moved.xdd_object);
    expect_near(motion.internal, moved.internal);
  }
}

}  // namespace
