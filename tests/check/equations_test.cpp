#include "oracle/equations.hpp"

#include <gtest/gtest.h>

#include "check/fixture.hpp"
#include "data/list_data.hpp"

// The column `equation` of a check report. Would catch: equations that are not tested, or whose
// failure nobody is told.

namespace treeline::tests {
namespace {

/// A blade that keeps to its own axis, which turns, with a task along another one.
Subjects skate() {
  Diagnostics diagnostics;
  Subjects made{};
  made.robot = read_urdf(data_file("written/skate.urdf"), diagnostics).value();
  made.scene =
      parse_scene(
          "name: skate\n"
          "operational_points: [{name: bow, link: body, rows: [x], axes: local}]\n"
          "constraints: [{name: blade, between: [body, world], rows: [y], axes: local}]\n"
          "functions: [bias_acceleration, inverse_dynamics, constrained_forward_dynamics,\n"
          "            supported_control_torque]\n",
          "skate.yaml", made.robot, diagnostics)
          .value();
  made.generation = generate(made.robot, made.scene);
  return made;
}

TEST(EquationsOfReport, AreTestedAndFailTheCheck) {
  CheckReport report = check_or_throw(skate(), quick_options(kStatesOfEveryClass));
  EXPECT_TRUE(report.passed()) << print_text(report);
  for (const FunctionReport& function : report.functions) {
    ASSERT_TRUE(function.equation) << function.name;
    EXPECT_GE(function.equation->states, 5) << function.name;
    EXPECT_LE(function.equation->worst, 1e-18) << function.name;
  }
  EXPECT_NE(print_json(report).find("\"equation\""), std::string::npos);
  FunctionReport& first = report.functions.front();
  first.equation->worst = 0.1;
  EXPECT_FALSE(report.passed());
  EXPECT_NE(print_text(report).find(first.name + ": its equation does not hold: of " +
                                    first.equation->says),
            std::string::npos)
      << print_text(report);
}

}  // namespace
}  // namespace treeline::tests
