// Would catch: a benchmark that compares different things because a peer received another joint
// order, axis, gravity or mass. KDL, DART and Pinocchio are also independent references for the
// generated code.
#include "agreement.hpp"

#include <gtest/gtest.h>

#include "peers.hpp"

namespace treeline::bench {
namespace {

class Agreement : public testing::TestWithParam<std::string> {};

TEST_P(Agreement, AllSubjectsComputeTheSame) {
  const auto robot = read_case(GetParam());
  ASSERT_TRUE(robot);
  const std::uint64_t seed = 20240501;
  SCOPED_TRACE("seed " + std::to_string(seed));
  const auto states = random_states(*robot, 16, seed);
  for (const auto& each : differences(*robot, all_subjects(*robot), states)) {
    EXPECT_LE(each.worst, kAgreement) << each.implementation << ' ' << name_of(each.function);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Agreement, testing::ValuesIn(robot_names()),
                         [](const auto& robot) { return robot.param; });

}  // namespace
}  // namespace treeline::bench
