// Would catch: a table of functions that is called complete although a row is missing, twice there,
// or about a function that it should not have.
#include "functions/function_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace treeline {
namespace {

struct Row {
  Function function;
  int number;
};

TEST(FunctionTable, FindsTheRow) {
  constexpr std::array<Row, 2> rows{{{Function::gravity, 1}, {Function::lambda, 2}}};
  static_assert(find_row(rows, Function::lambda)->number == 2);
  static_assert(find_row(rows, Function::jacobian) == nullptr);
}

TEST(FunctionTable, IsCompleteWithOneRowAFunction) {
  constexpr auto has_row = is_about<FunctionGroup::objects>;
  std::vector<Row> rows;
  EXPECT_FALSE(covers<has_row>(rows));
  for (const Function function : kObjectFunctions) rows.push_back({function, 0});
  EXPECT_TRUE(covers<has_row>(rows));
  rows.push_back(rows.front());
  EXPECT_FALSE(covers<has_row>(rows)) << "twice";
  rows.back().function = Function::gravity;
  EXPECT_FALSE(covers<has_row>(rows)) << "not about objects";
  rows.pop_back();
  rows.pop_back();
  EXPECT_FALSE(covers<has_row>(rows)) << "missing";
}

}  // namespace
}  // namespace treeline
