
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/cold_report.hpp"
#include "check/fixture.hpp"

// Compiles and runs a small robot's functions by each `optimize`. Would catch: a build that is
// called with another's arguments or flags, bytes without the constants, code that is told twice,
// output that is not JSON. Times only have to exist.

namespace treeline::tests {
namespace {

ColdReport bench_puma() {
  Subjects subjects = load("puma560");
  subjects.scene.functions = {Function::gravity, Function::forward_dynamics};
  subjects.scene.batch = 4;
  ColdBenchOptions options;
  options.flags = "-O1";
  options.rounds = 2;
  options.warm = {1, 1};
  Diagnostics diagnostics;
  auto report = run_cold_bench(subjects.robot, subjects.scene, options, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  return std::move(report.value());
}

std::size_t count_rows(const ColdReport& report) {
  std::size_t rows = 0;
  for (const ColdFunction& function : report.functions) rows += function.rows.size();
  return rows;
}

void expect_rows(const ColdReport& report) {
  ASSERT_EQ(report.functions.size(), 2U);
  for (const ColdFunction& function : report.functions) {
    const ColdRow& speed = function.rows.front();
    EXPECT_EQ(speed.optimize, std::vector{Optimize::speed});
    EXPECT_FALSE(speed.is_small);
    ASSERT_EQ(function.rows.size(), 2U);
    EXPECT_EQ(function.rows[1].optimize, std::vector{Optimize::size});
    EXPECT_TRUE(function.rows[1].is_small);
    for (const ColdRow& row : function.rows) {
      EXPECT_GT(row.bytes.value_or(0), 300) << row.method;
      EXPECT_GT(row.warm.nanoseconds, 0);
      EXPECT_GT(row.cold.from_cache.nanoseconds, 0);
    }
  }
}

void expect_json_lines(const ColdReport& report) {
  std::istringstream lines(print_json_lines(report));
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line);) {
    const auto object = nlohmann::json::parse(line);
    EXPECT_EQ(object.at("scene"), "puma560");
    if (!object.contains("function")) continue;
    ++rows;
    EXPECT_GT(object.at("warm").at("nanoseconds"), 0);
  }
  EXPECT_EQ(rows, count_rows(report));
}

TEST(ColdBench, MeasuresEachOptimize) {
  const ColdReport report = bench_puma();
  expect_rows(report);
  expect_json_lines(report);
  const std::string table = print_table(report);
  EXPECT_NE(table.find("speed"), std::string::npos) << table;
  EXPECT_NE(table.find("forward_dynamics"), std::string::npos) << table;
}

}  // namespace
}  // namespace treeline::tests
