// The table of docs/evidence/generated-code.md about the savings by `snap_angles: 1e-5`. Would
// catch: a figure that differs from the measured one. `cmake --build BUILD -t report_snapping`
// prints the table.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "measure_snapping.hpp"

namespace treeline::tests {
void PrintTo(const DataRobot& robot, std::ostream* out) {
  *out << robot.name;
}
}  // namespace treeline::tests

namespace treeline::growth {
namespace {

/// The row of the page with this beginning, or nothing.
std::string page_row(const std::string& beginning) {
  std::ifstream page(TREELINE_PAGE);
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with(beginning)) return line;
  }
  return "";
}

std::string name_of(const tests::DataRobot& robot) {
  return robot.name.substr(robot.name.find('/') + 1);
}

class SnapAngles : public testing::TestWithParam<tests::DataRobot> {};

INSTANTIATE_TEST_SUITE_P(Robots, SnapAngles, testing::ValuesIn(tests::data_robots("published")),
                         [](const auto& robot) { return name_of(robot.param); });

TEST_P(SnapAngles, SavesWhatThePageSays) {
  const Snapping snapping = measure_snapping(GetParam());
  EXPECT_EQ(page_row("| " + name_of(GetParam()) + " |"),
            has_row(snapping) ? print_row(snapping) : "");
}

// With the rows, this covers all robots.
TEST(SnapAnglesTable, CountsTheOthers) {
  const auto robots = tests::data_robots("published");
  const auto rows = std::count_if(robots.begin(), robots.end(), [](const tests::DataRobot& robot) {
    return !page_row("| " + name_of(robot) + " |").empty();
  });
  const auto others = static_cast<std::ptrdiff_t>(robots.size()) - rows;
  EXPECT_FALSE(page_row("| " + std::to_string(others) + " others |").empty()) << others;
}

}  // namespace
}  // namespace treeline::growth
