#include <gtest/gtest.h>

#include "bench/bench_report.hpp"

// Whether bench says that a rejected route is faster than the emitted one. Would catch: variants
// that are no routes, as other lanes, taken for one; noise that is taken for time; a route that is
// faster and not told.

namespace treeline {
namespace {

BenchRow row_of(VariantGroup group, double ratio, double noise = 0.002) {
  BenchRow row;
  row.variant.group = group;
  row.variant.name = "route: of " + std::to_string(ratio);
  row.timing = {100 * ratio, ratio, noise};
  return row;
}

BenchReport report_of(std::vector<BenchRow> rows) {
  BenchReport report;
  report.name = "arm";
  report.functions.push_back({Function::lambda, std::move(rows)});
  return report;
}

TEST(FindFastestRejected, IsOneOfTheRoutes) {
  const BenchReport report =
      report_of({row_of(VariantGroup::emitted, 1), row_of(VariantGroup::lanes, 0.5),
                 row_of(VariantGroup::route, 1.3), row_of(VariantGroup::route, 0.97)});
  const auto fastest = find_fastest_rejected(report.functions.front());
  ASSERT_TRUE(fastest);
  EXPECT_EQ(fastest->row->timing.ratio, 0.97);
  EXPECT_FALSE(fastest->is_faster);
  EXPECT_NE(print_table(report).find("the fastest takes 0.97 of the time of the emitted one; none "
                                     "is more than 5 % faster"),
            std::string::npos);
}

TEST(FindFastestRejected, IsFasterBeyondFivePercentAndNoise) {
  const auto is_faster = [](double ratio, double noise) {
    const BenchReport report =
        report_of({row_of(VariantGroup::emitted, 1), row_of(VariantGroup::route, ratio, noise)});
    const bool told = print_table(report).find("more than 5 % faster: let") != std::string::npos;
    EXPECT_EQ(find_fastest_rejected(report.functions.front())->is_faster, told);
    EXPECT_NE(print_json_lines(report).find(told ? "\"is_faster\":true" : "\"is_faster\":false"),
              std::string::npos);
    return told;
  };
  EXPECT_TRUE(is_faster(0.88, 0.01));
  EXPECT_FALSE(is_faster(0.88, 0.05));
  EXPECT_FALSE(is_faster(0.96, 0));
}

TEST(FindFastestRejected, IsNothingWhereThereIsOneRoute) {
  const BenchReport report = report_of({row_of(VariantGroup::emitted, 1)});
  EXPECT_FALSE(find_fastest_rejected(report.functions.front()));
  EXPECT_EQ(print_table(report).find("rejected routes"), std::string::npos);
}

}  // namespace
}  // namespace treeline
