// Every published robot generates what tests/data/COMPATIBILITY.md says, with a fixed and with a
// floating base. Would catch: a robot that is refused or loses functions, and operations that
// increase for robots that are not examined otherwise. `cmake --build BUILD -t
// report_compatibility` makes the page again.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "compatibility/print_page.hpp"

namespace treeline::tests {

void PrintTo(const CompatibilityCase& of, std::ostream* out) {
  *out << of.robot_name() << ' ' << of.base_name();
}

namespace {

/// Rows of the page, by `robot base`.
std::map<std::string, std::string> page_rows() {
  std::map<std::string, std::string> rows;
  std::ifstream page(data_file("COMPATIBILITY.md"));
  for (std::string line; std::getline(page, line);) {
    std::istringstream words(line);
    std::string bar, robot, base;
    words >> bar >> robot >> bar >> base;
    if (bar == "|" && (base == "fixed" || base == "floating")) rows[robot + " " + base] = line;
  }
  return rows;
}

/// Reasons why nothing is generated yet, by `robot base`.
std::map<std::string, std::string> known_failures() {
  std::map<std::string, std::string> failures;
  std::ifstream table(TREELINE_KNOWN_FAILURES);
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line)) {
    std::istringstream columns(line);
    std::string robot, base, reason;
    std::getline(columns, robot, '\t');
    std::getline(columns, base, '\t');
    std::getline(columns, reason, '\t');
    failures[robot + " " + base] = reason;
  }
  return failures;
}

std::string key_of(const CompatibilityCase& of) {
  return of.robot_name() + " " + of.base_name();
}

class Compatibility : public testing::TestWithParam<CompatibilityCase> {};

INSTANTIATE_TEST_SUITE_P(Robots, Compatibility, testing::ValuesIn(compatibility_cases()),
                         [](const auto& of) {
                           return of.param.robot_name() + "_" + of.param.base_name();
                         });

TEST_P(Compatibility, IsThatOfThePage) {
  const auto rows = page_rows();
  const auto known = known_failures();
  const std::string key = key_of(GetParam());
  const CompatibilityRow row = measure_row(GetParam(), false);
  if (known.count(key) != 0) {
    EXPECT_FALSE(row.failure.empty()) << key << " generates now: remove its known failure";
  } else {
    EXPECT_TRUE(row.failure.empty()) << row.failure;
  }
  ASSERT_EQ(rows.count(key), 1U) << "the page has no row for " << key;
  EXPECT_EQ(rows.at(key).substr(0, print_counts(row).size()), print_counts(row))
      << "make the page again if this is meant";
}

TEST(CompatibilityPage, HasNoOtherRobots) {
  std::set<std::string> keys;
  for (const CompatibilityCase& of : compatibility_cases()) keys.insert(key_of(of));
  for (const auto& [key, row] : page_rows()) EXPECT_EQ(keys.count(key), 1U) << row;
  for (const auto& [key, reason] : known_failures()) {
    EXPECT_EQ(keys.count(key), 1U) << key;
    EXPECT_FALSE(reason.empty()) << key;
  }
}

}  // namespace
}  // namespace treeline::tests
