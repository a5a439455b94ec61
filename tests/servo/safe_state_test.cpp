// Would catch: a loop whose arm creeps or sinks after an emergency stop, a stop or a fault, under a
// payload or masses that it does not know; braking that ends with one sensor; a jump of a
// coordinate that makes torque; a joint that is blocked and pressed for ever; a stall that goes by
// without a fault, or is one step of the robot.
#include "servo/safe_state.hpp"

#include <limits>
#include <memory>

#include "foreign_arm.hpp"
#include "servo/loop.hpp"
#include "servo/simulated_robot.hpp"

namespace treeline::test {
namespace {

using servo::FaultKind;
using servo::MessageKind;
using servo::Mode;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A loop that leads an arm evenly to its goal in 0.8 s, by the torques that belong to what it
/// knows.
template <class F>
class Step {
 public:
  void step(const double (&q)[F::kVelocities], const double (&qd)[F::kVelocities],
            double (&tau)[F::kVelocities]) {
    if (!parts_) parts_ = std::make_shared<Parts>(F::limits());
    std::copy(std::begin(q), std::end(q), parts_->link.state.q);
    std::copy(std::begin(qd), std::end(qd), parts_->link.state.qd);
    parts_->loop.step([this](const servo::Report<F>& report) { report_ = report; });
    std::copy(std::begin(report_.tau), std::end(report_.tau), tau);
  }
  /// An unknown payload leaves the reference.
  void let_sag() {
    auto limits = F::limits();
    limits.following = 1e9;
    parts_ = std::make_shared<Parts>(limits);
  }
  void send(MessageKind kind) { parts_->mailbox.push(servo::message_of(kind)); }
  const servo::Report<F>& report() const { return report_; }
  servo::SimulatedClock& clock() { return parts_->clock; }

 private:
  struct Link {
    servo::StateOf<F> state;
    bool connected() const { return true; }
    void read(servo::StateOf<F>& out) const { out = state; }
    void write(const double (&)[F::kVelocities]) {}
    void pass_time(double) {}
  };
  struct Law {
    double begin = 0;
    std::array<double, F::kVelocities> error{};
    template <class Visit>
    void compare(double time, Visit&& visit) const {
      for (int i = 0; i < F::kVelocities; ++i) {
        visit(std::fabs(error[static_cast<std::size_t>(i)]), i, time - begin, 0.8);
      }
    }
    void start(double time, const servo::StateOf<F>&) { begin = time; }
    void apply(double, const servo::Message&) {}
    void control(double time, const servo::StateOf<F>& state, double (&tau)[F::kVelocities]) {
      double qdd[F::kVelocities];
      for (int i = 0; i < F::kVelocities; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const double speed = (F::kGoal[at] - F::kStart[at]) / 0.8;
        error[at] = F::kStart[at] + (time - begin) * speed - state.q[i];
        qdd[i] = 400 * error[at] + 40 * (speed - state.qd[i]);
      }
      F::inverse_dynamics(state.q, state.qd, qdd, tau);
      const auto limits = F::limits();
      for (std::size_t i = 0; i < limits.torque.size(); ++i) {
        tau[i] = std::clamp(tau[i], -limits.torque[i], limits.torque[i]);
      }
    }
  };
  struct Parts {
    explicit Parts(const decltype(F::limits())& given) : limits(given) {}
    decltype(F::limits()) limits;
    Link link;
    Law law;
    servo::SimulatedClock clock;
    servo::Mailbox mailbox;
    servo::ServoLoop<F, Link, Law, servo::SimulatedClock> loop{{},  limits, link,
                                                               law, clock,  mailbox};
  };
  std::shared_ptr<Parts> parts_;
  servo::Report<F> report_;
};

template <class F>
class ServoSafeState : public testing::Test {
 protected:
  using Arm = ForeignArm<F, Step<F>>;
  /// In the midst of a motion of all joints.
  static Arm moving(const Imperfection& is) {
    Arm arm(is, F::kStart);
    if (is.payload > 0) arm.state.let_sag();
    arm.run(0.1);
    arm.state.send(MessageKind::start);
    arm.run(0.3);
    EXPECT_EQ(arm.state.report().mode, Mode::running) << servo::describe(arm.state.report().fault);
    EXPECT_GT(arm.fastest(), 0.3);
    return arm;
  }
};

using Arms = testing::Types<Fr3, Ur10e, Puma>;
TYPED_TEST_SUITE(ServoSafeState, Arms);

const auto nothing = [](auto&) {};

TYPED_TEST(ServoSafeState, HoldsTheRatedPayloadThatItDoesNotKnow) {
  Imperfection is;
  is.payload = TypeParam::kRated;
  typename TestFixture::Arm arm(is, TypeParam::kStart);
  expect_rest(arm, nothing);
  EXPECT_EQ(arm.state.report().mode, Mode::idle);
}

TYPED_TEST(ServoSafeState, BrakesWhateverTheArmCarries) {
  for (const auto& [name, is] : ways_to_differ(TypeParam::kCarried)) {
    SCOPED_TRACE(name);
    for (const MessageKind kind : {MessageKind::emergency_stop, MessageKind::stop}) {
      auto arm = this->moving(is);
      arm.state.send(kind);
      expect_rest(arm, nothing);
      const bool stopped = kind == MessageKind::stop;
      EXPECT_EQ(arm.state.report().mode, stopped ? Mode::idle : Mode::faulted);
      EXPECT_EQ(arm.state.report().brakes, !stopped);
    }
  }
}

TYPED_TEST(ServoSafeState, BrakesByWhatIsLeftOfASensor) {
  for (int joint = 0; joint < TypeParam::kVelocities; ++joint) {
    SCOPED_TRACE(joint);
    auto without_q = this->moving({});
    without_q.step([&](auto& input) { input.q[joint] = kNaN; });
    EXPECT_EQ(without_q.state.report().fault.kind, FaultKind::state_not_finite);
    EXPECT_TRUE(without_q.state.report().brakes) << "in the cycle that sees it";
    expect_rest(without_q, [&](auto& input) { input.q[joint] = kNaN; });
    auto without_qd = this->moving({});
    expect_rest(without_qd, [&](auto& input) { input.qd[joint] = kNaN; });
  }
}

TYPED_TEST(ServoSafeState, MakesNoTorqueOfAJump) {
  for (int joint = 0; joint < TypeParam::kVelocities; ++joint) {
    SCOPED_TRACE(joint);
    for (const double by : {0.3, -0.08}) {
      auto arm = this->moving({});
      const auto before = arm.output;
      const auto off = [&](auto& input) { input.q[joint] += by; };
      arm.step(off);
      const auto& report = arm.state.report();
      if (report.fault.kind != FaultKind::position_limit) {
        EXPECT_EQ(report.fault.kind, FaultKind::jump);
        EXPECT_EQ(report.fault.index, joint);
        EXPECT_NEAR(report.fault.value, by, 0.01);
      }
      for (int i = 0; i < TypeParam::kVelocities; ++i) {
        const double rise = 1.001 * arm.config.torque[i] * 1e-3 / 0.025;
        EXPECT_NEAR(arm.output.tau[i], before.tau[i], rise) << i;
      }
      expect_rest(arm, off);
    }
  }
}

TYPED_TEST(ServoSafeState, FindsAFrozenSensor) {
  for (int joint = 0; joint < TypeParam::kVelocities; ++joint) {
    auto arm = this->moving({});
    if (std::fabs(arm.qd[static_cast<std::size_t>(joint)]) < 0.9) continue;
    const double q = arm.input.q[joint];
    int steps = 0;
    for (; steps < 200 && arm.state.report().mode == Mode::running; ++steps) {
      arm.step([&](auto& input) { input.q[joint] = q; });
    }
    EXPECT_EQ(arm.state.report().fault.kind, FaultKind::jump) << joint;
  }
}

TYPED_TEST(ServoSafeState, SaysWhenItIsDraggedAway) {
  typename TestFixture::Arm arm({}, TypeParam::kStart);
  arm.run(0.1);
  const double from = arm.q[0];
  auto pulled = arm.q;
  while (arm.state.report().mode == Mode::idle && arm.q[0] < from + 0.4) {
    for (double& each : pulled) each += 2e-4;
    arm.step();
    arm.q = pulled;
    arm.qd.fill(0.2);
  }
  EXPECT_EQ(arm.state.report().fault.kind, FaultKind::moved);
  EXPECT_LT(arm.q[0] - from, 2.5 * 0.05);
}

TYPED_TEST(ServoSafeState, FindsAnArmThatIsBlocked) {
  auto arm = this->moving({});
  const auto held = arm.q;
  for (int k = 0; k < 1500 && arm.state.report().mode == Mode::running; ++k) {
    arm.step();
    arm.q = held;
    arm.qd.fill(0);
  }
  const servo::Fault& fault = arm.state.report().fault;
  EXPECT_EQ(fault.kind, FaultKind::following) << servo::describe(fault);
  EXPECT_NEAR(fault.value, fault.limit, 3e-3);
  EXPECT_EQ(fault.limit, 0.3);
  EXPECT_TRUE(arm.state.report().brakes) << "it rests";
}

TYPED_TEST(ServoSafeState, AStallIsAFaultInTheCycleThatSeesIt) {
  auto arm = this->moving({});
  arm.state.clock().advance(40'000'000);  // not yet
  arm.run(0.01);
  EXPECT_EQ(arm.state.report().mode, Mode::running);
  arm.state.clock().advance(60'000'000);
  arm.step();
  EXPECT_EQ(arm.state.report().fault.kind, FaultKind::stalled);
  EXPECT_EQ(servo::describe(arm.state.report().fault), "a cycle was 60 ms late, 50 ms are allowed");
}

}  // namespace
}  // namespace treeline::test
