#include "bench/bench.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "bench/draw_svg.hpp"
#include "check/fixture.hpp"

// Compiles and runs every variant of a small robot's functions. Would catch: a variant that gets
// the arguments of another one, a result that is compared with the reference of another function,
// float that is called double, output that is not JSON, a mark that is not drawn. Errors are
// checked; times only have to exist.

namespace treeline::tests {
namespace {

std::optional<BenchReport> bench_planar3r() {
  Subjects subjects = load("planar3r");
  subjects.scene.functions = {Function::inverse_dynamics, Function::lambda};
  BenchOptions options;
  options.states = 12;
  options.flags = "-O0";
  options.timing = {1, 1};
  Diagnostics diagnostics;
  return run_bench(subjects.robot, subjects.scene, options, diagnostics);
}

void expect_errors_of_their_real(const BenchFunction& made) {
  EXPECT_EQ(made.states, 12);
  EXPECT_EQ(made.singular, 0);
  EXPECT_GE(made.rows.size(), 6U);
  for (const BenchRow& row : made.rows) {
    // A norm-wise error of a few roundings: three joints with a dozen terms each.
    const double unit = row.variant.real == Real::float32 ? 0x1p-24 : 0x1p-53;
    EXPECT_LT(row.norm.worst, 100 * unit) << row.variant.name;
    EXPECT_GT(row.norm.worst, unit / 100) << row.variant.name;
    EXPECT_LE(row.norm.median, row.norm.percent_99);
    EXPECT_LE(row.norm.percent_99, row.norm.worst);
    EXPECT_GE(row.component.worst, row.norm.worst) << row.variant.name;
    EXPECT_GT(row.timing.nanoseconds, 0);
  }
}

void expect_factorisations(const BenchFunction& made) {
  int found = 0;
  for (const BenchRow& row : made.rows) {
    if (row.variant.group != VariantGroup::solve) continue;
    ++found;
    // At most the condition number of Lambda^-1 that float can solve with, some 1e5, times
    // rounding.
    EXPECT_LT(row.norm.worst, 1e-10) << row.variant.name;
  }
  EXPECT_EQ(found, 2);
}

void expect_front(const BenchReport& report) {
  for (const BenchFunction& made : report.functions) {
    EXPECT_TRUE(std::any_of(made.rows.begin(), made.rows.end(),
                            [](const BenchRow& row) { return row.on_front; }));
    EXPECT_EQ(made.rows.front().variant.group, VariantGroup::emitted);
  }
}

void expect_json_lines(const BenchReport& report) {
  std::istringstream lines(print_json_lines(report));
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line);) {
    const auto object = nlohmann::json::parse(line);
    EXPECT_EQ(object.at("scene"), "planar3r");
    rows += object.contains("variant") ? 1 : 0;
  }
  std::size_t expected = 0;
  for (const BenchFunction& made : report.functions) expected += made.rows.size();
  EXPECT_EQ(rows, expected);
}

void expect_table(const BenchReport& report) {
  const std::string table = print_table(report);
  for (const BenchFunction& made : report.functions) {
    for (const BenchRow& row : made.rows) {
      EXPECT_NE(table.find(row.variant.name), std::string::npos) << row.variant.name;
    }
  }
}

void expect_marks(const BenchReport& report) {
  const std::string svg = draw_svg(report);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf\""), std::string::npos);
  std::size_t marks = 0;
  for (std::size_t at = svg.find("<title>"); at != std::string::npos;
       at = svg.find("<title>", at + 1)) {
    ++marks;
  }
  std::size_t rows = 0;
  std::set<VariantGroup> legend;
  for (const BenchFunction& made : report.functions) {
    rows += made.rows.size();
    for (const BenchRow& row : made.rows) legend.insert(row.variant.group);
    EXPECT_NE(svg.find(function_name(made.function)), std::string::npos);
  }
  EXPECT_EQ(marks, rows + legend.size());
}

TEST(Bench, RunsEveryVariantOfASmallRobot) {
  const auto report = bench_planar3r();
  ASSERT_TRUE(report);
  ASSERT_EQ(report->functions.size(), 2U);
  expect_errors_of_their_real(report->functions[0]);
  expect_factorisations(report->functions[1]);
  expect_front(*report);
  expect_json_lines(*report);
  expect_table(*report);
  expect_marks(*report);
}

}  // namespace
}  // namespace treeline::tests
