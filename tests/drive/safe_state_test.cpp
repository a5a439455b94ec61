// Would catch, of the loop of `treeline drive`: an arm that creeps or sinks after an emergency stop
// or a fault, under a payload or masses that it does not know; braking that ends with one sensor; a
// state from outside that jumps and makes torque; a joint that takes the long way round.
#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <numbers>

#include "../servo/foreign_arm.hpp"
#include "drive/drive_loop.hpp"
#include "rig.hpp"

namespace treeline::drive {
namespace {

using servo::FaultKind;
using servo::MessageKind;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// An arm as it is driven: its joints alone.
template <class Arm>
struct Driven : Arm {
  static constexpr int kPoints = 0;
  static constexpr int kLinks = 0;
  static constexpr bool kHasCenterOfMass = false;
  static constexpr servo::FloatingJoints<Arm::kCoordinates, Arm::kVelocities> kFloating = {};
};

/// A loop that drives a robot which is elsewhere.
template <class F>
class Step {
 public:
  static constexpr int n = F::kVelocities;
  void step(const double (&q)[n], const double (&qd)[n], double (&tau)[n]) {
    if (!parts_) parts_ = std::make_shared<Parts>();
    std::copy(std::begin(q), std::end(q), parts_->q);
    std::copy(std::begin(qd), std::end(qd), parts_->qd);
    parts_->loop->step();
    std::array<double, DriveLoop<F>::kLayout.size> numbers;
    parts_->loop->receive(head_, numbers.data());
    std::copy(std::begin(parts_->tau), std::end(parts_->tau), tau);
  }
  void send(const servo::Message& message) { ASSERT_TRUE(parts_->loop->send(message)); }
  void send(MessageKind kind) { send(servo::message_of(kind)); }
  FaultKind fault() const { return static_cast<FaultKind>(head_.fault_kind); }
  const ReportHead& head() const { return head_; }

 private:
  struct Parts {
    Parts() {
      LoopOptions options;
      options.real_time = false;
      options.start = F::kStart.data();
      options.lower = limits.lower.data();
      options.upper = limits.upper.data();
      options.velocity = limits.velocity.data();
      options.torque = limits.torque.data();
      options.robot.self = this;
      options.robot.connected = [](void*) { return true; };
      options.robot.read = [](void* self, double* to, double* rates) {
        std::copy_n(static_cast<Parts*>(self)->q, n, to);
        std::copy_n(static_cast<Parts*>(self)->qd, n, rates);
      };
      options.robot.write = [](void* self, const double* from) {
        std::copy_n(from, n, static_cast<Parts*>(self)->tau);
      };
      loop = std::make_unique<DriveLoop<F>>(options);
    }
    servo::SafetyLimits<n, n> limits = F::limits();
    double q[n] = {}, qd[n] = {}, tau[n] = {};
    std::unique_ptr<DriveLoop<F>> loop;
  };
  std::shared_ptr<Parts> parts_;
  ReportHead head_;
};

template <class Arm>
class DriveSafeState : public testing::Test {
 protected:
  using F = Driven<Arm>;
  using Foreign = test::ForeignArm<F, Step<F>>;
  static Foreign moving(const test::Imperfection& is) {
    Foreign arm(is, F::kStart);
    arm.run(0.1);
    arm.state.send(MessageKind::start);
    arm.run(0.1);
    for (int i = 0; i < F::kVelocities; ++i) {
      servo::Message move = make_message(Instruction::move_joint);
      move.values = {static_cast<double>(i), 0, F::kGoal[static_cast<std::size_t>(i)]};
      move.duration = 1;
      arm.state.send(move);
    }
    arm.run(0.5);
    EXPECT_EQ(arm.state.fault(), FaultKind::none);
    EXPECT_GT(arm.fastest(), 0.3);
    return arm;
  }
};
using Arms = testing::Types<test::Fr3, test::Ur10e, test::Puma>;
TYPED_TEST_SUITE(DriveSafeState, Arms);

const auto nothing = [](auto&) {};

TYPED_TEST(DriveSafeState, BrakesWhateverTheArmCarries) {
  for (const auto& [name, is] : test::ways_to_differ(TypeParam::kCarried)) {
    SCOPED_TRACE(name);
    for (const MessageKind kind : {MessageKind::emergency_stop, MessageKind::stop}) {
      auto arm = this->moving(is);
      arm.state.send(kind);
      test::expect_rest(arm, nothing);
    }
  }
}

TYPED_TEST(DriveSafeState, BrakesByWhatIsLeftOfASensor) {
  for (int joint = 0; joint < TypeParam::kVelocities; ++joint) {
    SCOPED_TRACE(joint);
    auto arm = this->moving({});
    test::expect_rest(arm, [&](auto& input) { input.q[joint] = kNaN; });
    EXPECT_EQ(arm.state.fault(), FaultKind::state_not_finite);
  }
}

TYPED_TEST(DriveSafeState, MakesNoTorqueOfAJump) {
  for (int joint = 0; joint < TypeParam::kVelocities; ++joint) {
    SCOPED_TRACE(joint);
    auto arm = this->moving({});
    const auto before = arm.output;
    const auto off = [&](auto& input) { input.q[joint] += 0.2; };
    arm.step(off);
    EXPECT_NE(arm.state.fault(), FaultKind::none);
    for (int i = 0; i < TypeParam::kVelocities; ++i) {
      const double rise = 1.001 * arm.config.torque[i] * 1e-3 / 0.025;
      EXPECT_NEAR(arm.output.tau[i], before.tau[i], rise) << i;
    }
    test::expect_rest(arm, off);
  }
}

/// A turntable: one joint that turns without end, 2 kg m^2.
struct Turntable {
  static constexpr int kCoordinates = 1;
  static constexpr int kVelocities = 1;
  static constexpr int kPoints = 0;
  static constexpr int kLinks = 0;
  static constexpr bool kHasCenterOfMass = false;
  static constexpr servo::FloatingJoints<1, 1> kFloating = {};
  static constexpr bool kTurns[] = {true};
  static void inverse_dynamics(const double (&)[1], const double (&)[1], const double (&qdd)[1],
                               double (&tau)[1]) noexcept {
    tau[0] = 2 * qdd[0];
  }
  static void forward_dynamics(const double (&)[1], const double (&)[1], const double (&tau)[1],
                               double (&qdd)[1]) noexcept {
    qdd[0] = tau[0] / 2;
  }
};

// From 3 rad to -3 there are 0.28 rad over pi, and so for every way to say it.
TEST(DriveController, AJointWithoutEndTakesTheShortWay) {
  const double way = 2 * std::numbers::pi - 6;
  const auto expect_short = [&](Instruction instruction, std::initializer_list<double> values) {
    test::Rig<Turntable> rig({3});
    double farthest = 0;
    for (int k = 0; k < 30; ++k) {
      if (k == 0 || instruction == Instruction::drag_joint) rig.send(instruction, values);
      rig.run(0.1);
      farthest = std::max(farthest, std::fabs(rig.q(0) - 3));
    }
    EXPECT_NEAR(rig.q(0), 3 + way, 1e-3);
    EXPECT_LT(farthest, way + 0.02);
    EXPECT_EQ(rig.head().fault_kind, 0);
  };
  expect_short(Instruction::move_joint, {0, 0, -3});
  expect_short(Instruction::drag_joint, {0, -3});
  test::Rig<Turntable> rig({3});
  rig.send(Instruction::move_joint, {0, 1, -6});  // a way is as long as it is
  rig.run(12);
  EXPECT_NEAR(rig.q(0), -3, 1e-3);
}

}  // namespace
}  // namespace treeline::drive
