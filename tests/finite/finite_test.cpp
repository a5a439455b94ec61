// Emitted code is finite wherever its inputs are. Would catch: a division by something that can
// vanish, such as a pivot of a singular task, the length of a quaternion, or a mass without effect
// in any pose; and powers that leave the range of double although their quotient does not. The same
// search with more states and robots: `search_not_finite`.
#include <gtest/gtest.h>

#include "data/list_data.hpp"
#include "description/diagnosed.hpp"
#include "description/read_urdf.hpp"
#include "finite/search.hpp"

namespace treeline::tests {
namespace {

struct Case {
  const char* robot;
  Base base;
  Real real;
};

void PrintTo(const Case& of, std::ostream* out) {
  *out << of.robot;
}

class Finite : public testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(Robots, Finite,
                         testing::Values(Case{"published/iiwa14_drake", Base::fixed, Real::float64},
                                         Case{"published/ur5", Base::fixed, Real::float64},
                                         Case{"published/ur5", Base::fixed, Real::float32},
                                         Case{"published/fetch", Base::fixed, Real::float64},
                                         Case{"published/ballbot", Base::floating, Real::float64},
                                         Case{"published/crazyflie_cf2x", Base::floating,
                                              Real::float32},
                                         Case{"golden/solo12", Base::floating, Real::float64}),
                         [](const auto& of) {
                           const std::string name = of.param.robot;
                           return name.substr(name.find('/') + 1) +
                                  (of.param.base == Base::floating ? "_floating" : "_fixed") +
                                  (of.param.real == Real::float32 ? "_float" : "_double");
                         });

TEST_P(Finite, WhereverItsInputsAre) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(data_file(std::string(GetParam().robot) + ".urdf"), diagnostics);
  ASSERT_TRUE(robot);
  auto scene = proposed_scene(*robot, GetParam().base, diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  scene->real = GetParam().real;
  FiniteOptions options;
  options.flags = "-O0";
  const auto report = search_not_finite(*robot, *scene, options, diagnostics);
  ASSERT_TRUE(report) << to_string(diagnostics);
  EXPECT_EQ(report->states, options.states);
  EXPECT_GE(report->functions.size(), 5U);
  for (const NotFinite& each : report->found) {
    ADD_FAILURE() << each.function << " at " << each.times << " states, first " << each.first.index
                  << " of seed " << options.seed << ": " << print_inputs(each.first);
  }
}

// Check of the search itself: a plain solve is not finite where the task is singular.
TEST(FiniteSearch, FindsWhereABareSolveIsNotFinite) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(data_file("published/iiwa14_drake.urdf"), diagnostics);
  auto scene = proposed_scene(*robot, Base::fixed, diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  scene->singular = SingularTasks::exact;
  scene->functions = {Function::gravity, Function::control_torque};
  FiniteOptions options;
  options.states = 500;
  options.flags = "-O0";
  const auto report = search_not_finite(*robot, *scene, options, diagnostics);
  ASSERT_TRUE(report) << to_string(diagnostics);
  ASSERT_EQ(report->found.size(), 1U);
  EXPECT_EQ(report->found.front().function, "control_torque");
}

}  // namespace
}  // namespace treeline::tests
