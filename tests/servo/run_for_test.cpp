// Would catch: a first or a last cycle too many, at rates whose period is no whole number of
// nanoseconds too; a fault that is lost or does not end the run.
#include "servo/run_for.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "loop_rig.hpp"

namespace {

using namespace treeline::servo;  // NOLINT: all of it is under test
using treeline::test::Rig;
using treeline::test::TwoLink;

TEST(RunFor, ControlsForTheGivenTime) {
  for (const double rate : {1000.0, 300.0}) {
    Rig rig;
    LoopSettings settings;
    settings.rate = rate;
    int count = 0;
    double first = -1.0;
    double last = 0.0;
    const RunEnd end =
        run_for<TwoLink>(0.5, settings, Rig::make_limits(), rig.robot, rig.controller, rig.clock,
                         rig.mailbox, [&](const Report<TwoLink>& report) {
                           EXPECT_EQ(report.mode, Mode::running);
                           first = count == 0 ? report.time : first;
                           last = report.time;
                           ++count;
                         });
    EXPECT_EQ(count, std::lround(0.5 * rate) + 1);
    EXPECT_EQ(first, 0.0);
    EXPECT_NEAR(last, 0.5, 1e-6);
    EXPECT_EQ(end.control.count(), static_cast<std::size_t>(count));
    EXPECT_FALSE(end.fault);
  }
}

TEST(RunFor, EndsAtAFault) {
  Rig rig;
  rig.controller.spoil = 1e3;
  int count = 0;
  const RunEnd end =
      run_for<TwoLink>(1.0, rig.settings, Rig::make_limits(), rig.robot, rig.controller, rig.clock,
                       rig.mailbox, [&count](const Report<TwoLink>&) { ++count; });
  EXPECT_EQ(end.fault.kind, FaultKind::torque_limit);
  EXPECT_EQ(count, 0);
}

}  // namespace
