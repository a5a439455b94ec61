#include <gtest/gtest.h>

#include "passes/count_operations.hpp"
#include "passes/passes.hpp"
#include "passes/two_link_arm.hpp"
#include "program/evaluate.hpp"

// Would catch: a pass that is missing from the list or from its log, and passes that together
// change values.
namespace treeline {
namespace {

Program run_passes(Program program, std::vector<PassReport>& log) {
  return put_in_order(reduce_operations(std::move(program), log), log);
}

TEST(RunPasses, LogsEveryPassAndNeverAddsOperations) {
  std::vector<PassReport> log;
  const Program program = run_passes(test::trace_two_link_arm(), log);
  ASSERT_GE(log.size(), 2u);
  EXPECT_EQ(log.front().pass, "canonicalize");
  EXPECT_EQ(log.back().pass, "schedule");
  for (const PassReport& report : log) {
    EXPECT_LE(report.after.flops(), report.before.flops()) << report.pass;
  }
  EXPECT_EQ(log.back().after.flops(), count_operations(program).flops());
}

TEST(RunPasses, KeepsTheFunction) {
  std::vector<PassReport> log;
  const std::vector<std::vector<double>> arguments = {{0.3, -1.1}, {2.0, 0.7}, {-0.4, 5.0}};
  const Program program = run_passes(test::trace_two_link_arm(), log);
  const auto tau = evaluate(program, arguments)[0];
  const auto expected = test::two_link_torque<long double>({0.3L, -1.1L}, {2, 0.7L}, {-0.4L, 5});
  for (std::size_t i = 0; i < 2; ++i) {  // about 30 operations on values up to 30 Nm
    EXPECT_NEAR(tau[i], static_cast<double>(expected[i]), 30 * 30 * 1.1e-16);
  }
}

TEST(RunPasses, ReportReadsAsALine) {
  EXPECT_EQ(to_string("gravity", {"schedule", {2, 3, 0, 1}, {1, 3, 0, 1}, 9, 8}),
            "gravity: schedule 5 -> 4 flops, 9 -> 8 nodes");
}

}  // namespace
}  // namespace treeline
