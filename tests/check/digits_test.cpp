// Digits that each function leaves, for every robot at hand, beside the table digits.csv. Would
// catch a recursion, route or reduction that loses digits on some robot, long before an error bound
// breaks. `cmake --build BUILD -t digits` makes the table again.
#include "check/digits.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace treeline::tests {
namespace {

/// Rounding errors of other orders of operations differ by that much at the worst of few states.
constexpr double kAllowedLoss = 0.6;

std::vector<DigitsLeft> rows_of(const std::string& subject) {
  std::vector<DigitsLeft> rows = read_digits(TREELINE_DIGITS_TABLE);
  std::erase_if(rows, [&](const DigitsLeft& row) { return row.subject != subject; });
  return rows;
}

class Digits : public testing::TestWithParam<std::string> {};

std::vector<std::string> subjects_in_table() {
  std::vector<std::string> names;
  for (const DigitsLeft& row : read_digits(TREELINE_DIGITS_TABLE)) {
    if (names.empty() || names.back() != row.subject) names.push_back(row.subject);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Table, Digits, testing::ValuesIn(subjects_in_table()), [](const auto& of) {
  std::string name = of.param;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
});

TEST_P(Digits, AreKept) {
  const auto subjects = list_subjects(TREELINE_ROBOTS_DIR, TREELINE_SHARED_DIR);
  const auto found =
      std::find_if(subjects.begin(), subjects.end(),
                   [&](const DigitsSubject& subject) { return subject.name == GetParam(); });
  if (found == subjects.end()) GTEST_SKIP() << "no such file here";
  const std::vector<DigitsLeft> expected = rows_of(GetParam());
  const std::vector<DigitsLeft> actual = measure_digits(*found);
  ASSERT_EQ(actual.size(), expected.size()) << "make the table again";
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_EQ(actual[i].function, expected[i].function);
    EXPECT_EQ(actual[i].digits.has_value(), expected[i].digits.has_value()) << actual[i].function;
    EXPECT_GE(actual[i].digits.value_or(0), expected[i].digits.value_or(0) - kAllowedLoss)
        << actual[i].function;
  }
}

// A robot that is here and not in the table is not guarded.
TEST(DigitsTable, HasEveryRobot) {
  const auto names = subjects_in_table();
  for (const DigitsSubject& subject : list_subjects(TREELINE_ROBOTS_DIR, TREELINE_SHARED_DIR)) {
    EXPECT_EQ(std::count(names.begin(), names.end(), subject.name), 1) << subject.name;
  }
}

}  // namespace
}  // namespace treeline::tests
