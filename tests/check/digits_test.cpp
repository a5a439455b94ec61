// Digits that each function keeps, for every available robot, compared with the table digits.csv.
// Would catch: a recursion, route or reduction that loses digits for some robot, long before an
// error bound is exceeded. `cmake --build BUILD -t digits` makes the table again.
#include "check/digits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace treeline::tests {
namespace {

/// Rounding errors of other orders of operations differ by this much at the worst of few states.
constexpr double kAllowedLoss = 0.6;

/// Digits that double keeps in functions without a solve, for any robot. Functions with a solve
/// depend on the condition number. Scenes in float keep half.
constexpr double kLeastDigits = 12.5, kLeastDigitsOfFloat = 5.5;

/// Robots whose functions are wrong today, and why. If such a robot becomes right, the test fails.
const std::map<std::string, std::string> kWrong = {};

bool solves(const std::string& function) {
  static const std::set<std::string> kSolving = {"forward_dynamics",
                                                 "lambda_inverse",
                                                 "lambda",
                                                 "control_torque",
                                                 "object_state",
                                                 "object_control_torque",
                                                 "object_forward_dynamics",
                                                 "impulse_response",
                                                 "damped_control_torque",
                                                 "contact_inverse_inertia",
                                                 "effective_mass",
                                                 "link_inverse_inertias",
                                                 "dynamically_consistent_inverse",
                                                 "null_space_projector",
                                                 "operational_bias_force",
                                                 "operational_gravity",
                                                 "constrained_forward_dynamics",
                                                 "supported_control_torque"};
  return kSolving.contains(function);
}

/// Whether every function without a solve keeps the digits of its Real.
bool is_right(const std::vector<DigitsLeft>& rows, bool in_float) {
  return std::all_of(rows.begin(), rows.end(), [&](const DigitsLeft& row) {
    return solves(row.function) ||
           row.digits.value_or(0) >= (in_float ? kLeastDigitsOfFloat : kLeastDigits);
  });
}

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
  const auto subjects = list_subjects(TREELINE_ROBOTS_DIR);
  const auto found =
      std::find_if(subjects.begin(), subjects.end(),
                   [&](const DigitsSubject& subject) { return subject.name == GetParam(); });
  ASSERT_NE(found, subjects.end()) << "the table has a robot that is not here";
  const std::vector<DigitsLeft> expected = rows_of(GetParam());
  const std::vector<DigitsLeft> actual = measure_digits(*found);
  ASSERT_EQ(actual.size(), expected.size()) << "make the table again";
  EXPECT_NE(is_right(actual, GetParam() == "puma560/scene_float"), kWrong.contains(GetParam()))
      << "a robot of kWrong that is right leaves it, and the table is made again";
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_EQ(actual[i].function, expected[i].function);
    EXPECT_EQ(actual[i].digits.has_value(), expected[i].digits.has_value()) << actual[i].function;
    EXPECT_GE(actual[i].digits.value_or(0), expected[i].digits.value_or(0) - kAllowedLoss)
        << actual[i].function;
  }
}

// A robot without a row in the table would not be tested.
TEST(DigitsTable, HasEveryRobot) {
  const auto names = subjects_in_table();
  for (const DigitsSubject& subject : list_subjects(TREELINE_ROBOTS_DIR)) {
    EXPECT_EQ(std::count(names.begin(), names.end(), subject.name), 1) << subject.name;
  }
}

}  // namespace
}  // namespace treeline::tests
