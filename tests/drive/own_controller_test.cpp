// Would catch: goals that a robot's own controller gets otherwise than they are shown, or whose
// velocities are not theirs; faults of a robot that moves as it will; a drive that ends where the
// controller is silent, or does not see that it is; one that does not stop it at a limit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "driven_robots.hpp"
#include "rig.hpp"
#include "servo/safety.hpp"

namespace treeline::drive {
namespace {

using servo::FaultKind;
using servo::MessageKind;

/// A robot that is where its controller says, and keeps the last goal.
struct Controller {
  std::vector<double> q, qd, goal;
  bool present = true;

  Controller(std::vector<double> at, std::size_t velocities, std::size_t points)
      : q(std::move(at)), qd(velocities), goal(2 + q.size() + velocities + 7 * points) {}

  ExternalRobot functions() {
    ExternalRobot robot;
    robot.self = this;
    robot.connected = [](void* self) { return of(self).present; };
    robot.read = [](void* self, double* to_q, double* to_qd) {
      std::copy(of(self).q.begin(), of(self).q.end(), to_q);
      std::copy(of(self).qd.begin(), of(self).qd.end(), to_qd);
    };
    robot.lead = [](void* self, const double* given) {
      std::copy_n(given, of(self).goal.size(), of(self).goal.begin());
    };
    robot.show = [](void* self, double* tau, Shown& shown) {
      std::fill_n(tau, of(self).qd.size(), 7.0);
      shown.count = 1;
      shown.numbers[0] = {"error", 0.5};
    };
    return robot;
  }

 private:
  static Controller& of(void* self) { return *static_cast<Controller*>(self); }
};

class OwnControllerTest : public ::testing::Test {
 protected:
  using Rig = test::Rig<test::PlanarArm>;
  FaultKind fault() const { return static_cast<FaultKind>(rig_.head().fault_kind); }
  void restart() {
    rig_.command(MessageKind::reset);
    rig_.run(0.002);
    rig_.command(MessageKind::start);
    rig_.run(0.002);
  }

  Controller arm_{{0.3, 0.8}, 2, 1};
  Rig rig_{{0.3, 0.8}, [this](LoopOptions& options) { options.robot = arm_.functions(); }, 1.5};
};

TEST_F(OwnControllerTest, GetsTheGoalsThatAreShown) {
  EXPECT_EQ(arm_.goal[0], static_cast<double>(servo::Mode::running));
  EXPECT_EQ(arm_.goal[1], static_cast<double>(Control::task)) << "as drives with points begin";
  rig_.send(Instruction::move_joint, {0, 0, 0.9}, 1.0);
  double before = arm_.goal[2];
  for (int i = 0; i < 1200; ++i) {
    rig_.step();
    ASSERT_EQ(arm_.goal[2], rig_.at(Rig::kLayout.goal));
    ASSERT_EQ(arm_.goal[3], rig_.at(Rig::kLayout.goal + 1));
    // The mean velocity of a cycle: that at its end less half a cycle's acceleration, 3.5 rad/s^2.
    ASSERT_NEAR(arm_.goal[4], 1e3 * (arm_.goal[2] - before), 5e-3) << i;
    before = arm_.goal[2];
  }
  EXPECT_EQ(arm_.goal[1], static_cast<double>(Control::joint));
  EXPECT_NEAR(arm_.goal[2], 0.9, 1e-9);
  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_EQ(arm_.goal[6 + k], rig_.at(Rig::kLayout.point_goals + static_cast<int>(k)));
  }
  EXPECT_EQ(rig_.tau(1), 7.0);
  ASSERT_EQ(rig_.head().shown.count, 1);
  EXPECT_STREQ(rig_.head().shown.numbers[0].name, "error");
}

// In every mode: it was moved by 1 rad within a cycle, far from its goal.
TEST_F(OwnControllerTest, MayMoveAsItWill) {
  for (const MessageKind kind : {MessageKind::start, MessageKind::stop}) {
    rig_.command(kind);
    rig_.run(2.0);
    arm_.q[0] = arm_.q[0] > 0 ? -0.7 : 0.3;
    rig_.run(2.0);
    EXPECT_EQ(fault(), FaultKind::none) << servo::describe({fault()});
  }
  EXPECT_EQ(arm_.goal[0], static_cast<double>(servo::Mode::idle)) << "it was braked, and rests";
}

TEST_F(OwnControllerTest, IsStoppedAtALimit) {
  arm_.q[0] = 1.6;
  rig_.step();
  EXPECT_EQ(fault(), FaultKind::position_limit);
  EXPECT_EQ(arm_.goal[0], static_cast<double>(servo::Mode::faulted));
}

TEST_F(OwnControllerTest, MayBeGoneForAWhile) {
  arm_.present = false;
  EXPECT_TRUE(rig_.loop().step());
  rig_.step();
  EXPECT_EQ(fault(), FaultKind::robot_gone);
  restart();
  EXPECT_EQ(fault(), FaultKind::robot_gone) << "it still is";
  arm_.present = true;
  arm_.q = {-0.5, 0.2};
  restart();
  EXPECT_EQ(fault(), FaultKind::none);
  EXPECT_EQ(arm_.goal[0], static_cast<double>(servo::Mode::running));
  EXPECT_NEAR(arm_.goal[2], -0.5, 1e-12) << "its goal is where it is";
}

// A body is turned by a quarter about z, and then goes along the world's x: against its own y.
TEST(OwnController, GetsVelocitiesInTheAxesOfABody) {
  Controller body({0, 0, 0, 0, 0, std::sqrt(0.5), std::sqrt(0.5)}, 6, 0);
  test::Rig<test::HeldBody> rig(body.q,
                                [&](LoopOptions& options) { options.robot = body.functions(); });
  rig.send(Instruction::move_point, {kBasePoint, 0, 0.6, 0, 0}, 1.0);
  rig.send(Instruction::turn_point, {kBasePoint, 1, 0, 0, 0.3}, 1.0);
  rig.run(0.5);
  const double* const qd = body.goal.data() + 9;
  constexpr double kPeak = 1.875;  // of a quintic, by its mean
  const double turned = 0.15;      // rad, half of the way
  EXPECT_NEAR(qd[0], -std::sin(turned) * 0.6 * kPeak, 2e-3);
  EXPECT_NEAR(qd[1], -std::cos(turned) * 0.6 * kPeak, 2e-3);
  EXPECT_NEAR(qd[5], 0.3 * kPeak, 2e-3);
}

}  // namespace
}  // namespace treeline::drive
