#include "bench/measure_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bench/bench_report.hpp"

// Errors of made-up results, computed by hand. Would catch: an error that is lost in the rounding
// of the reference's high part, a result that is measured by the size of another one, a NaN that
// passes, and a front with points that others beat.

namespace treeline::tests {
namespace {

FunctionReference truth(std::vector<double> high, std::vector<double> low) {
  FunctionReference reference;
  reference.size.assign(high.size(), 10);
  reference.high = std::move(high);
  reference.low = std::move(low);
  return reference;
}

TEST(MeasureError, IsOfTheWorstResultAndOfTheWorstEntry) {
  const FunctionReference reference = truth({4, 1, 100}, {0, 0, 0});
  const AnswerError error = measure_error({4.0, 1.25, 101}, reference, {2, 3});
  EXPECT_DOUBLE_EQ(error.norm, 0.0625);  // 0.25 of 4, not of 100
  EXPECT_DOUBLE_EQ(error.component, 0.25);
}

TEST(MeasureError, SeesWhatADoubleHasNoPlaceFor) {
  const FunctionReference reference = truth({1}, {0x1p-55});
  EXPECT_EQ(measure_error({1}, reference, {1}).norm, 0x1p-55);
}

TEST(MeasureError, MeasuresByTermsWhereTheTruthIsZero) {
  const FunctionReference reference = truth({1e-45, 5}, {0, 0});
  const AnswerError error = measure_error({1e-15, 5}, reference, {2});
  EXPECT_DOUBLE_EQ(error.component, 1e-16);
  EXPECT_DOUBLE_EQ(error.norm, 2e-16);
}

// 1 - Jbar J of an arm without a null space is what its relaxed rows leave, not 0.
TEST(MeasureError, MeasuresByTermsWhatRelaxedRowsLeave) {
  const FunctionReference reference = truth({1e-16, -1e-18}, {0, 0});
  const AnswerError error = measure_error({1e-15 + 1e-16, 0}, reference, {2});
  EXPECT_NEAR(error.component, 1e-16, 1e-25);
  EXPECT_NEAR(error.norm, 1e-16, 1e-25);
}

TEST(MeasureError, IsInfiniteWhereAnAnswerIsNone) {
  const FunctionReference reference = truth({1, 2}, {0, 0});
  const AnswerError error =
      measure_error({std::numeric_limits<double>::quiet_NaN(), 2}, reference, {2});
  EXPECT_TRUE(std::isinf(error.norm));
  EXPECT_TRUE(std::isinf(error.component));
}

BenchRow row(double nanoseconds, double error) {
  BenchRow made;
  made.timing.nanoseconds = nanoseconds;
  made.norm.worst = error;
  return made;
}

TEST(MarkFront, LeavesOutWhatIsBeaten) {
  std::vector<BenchRow> rows = {row(10, 1e-7), row(20, 1e-15), row(30, 1e-15), row(5, 1e-6),
                                row(40, 1e-16)};
  mark_front(rows);
  EXPECT_TRUE(rows[0].on_front);
  EXPECT_TRUE(rows[1].on_front);
  EXPECT_FALSE(rows[2].on_front);
  EXPECT_TRUE(rows[3].on_front);
  EXPECT_TRUE(rows[4].on_front);
}

TEST(MarkFront, HasNoRowThatLeavesWorkToTheCaller) {
  std::vector<BenchRow> rows = {row(10, 1e-15), row(5, 1e-15)};
  rows[1].variant.whole = false;
  mark_front(rows);
  EXPECT_TRUE(rows[0].on_front);
  EXPECT_FALSE(rows[1].on_front);
}

}  // namespace
}  // namespace treeline::tests
