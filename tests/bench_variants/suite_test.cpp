#include "bench/suite.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "compilation/temporary_folder.hpp"

// Lists of robots, and the table of the emitted code beside the fastest peer. Would catch: paths
// that are relative to where the program runs, a line that is dropped in silence, a slower peer
// taken for the best, code that another tool made taken for a library that loads robots, a variant
// of our own taken for a peer, and a robot without peers left out.

namespace treeline {
namespace {

using testing::HasSubstr;

std::optional<std::vector<SuiteRobot>> read_lines(const std::string& lines,
                                                  Diagnostics& diagnostics) {
  const auto folder = make_temporary_folder(diagnostics);
  const auto path = folder->path() / "robots.txt";
  std::ofstream(path) << lines;
  auto robots = read_suite(path, diagnostics);
  if (!robots) return robots;
  for (SuiteRobot& robot : *robots) {
    robot.urdf = std::filesystem::relative(robot.urdf, folder->path()).string();
    robot.scene = std::filesystem::relative(robot.scene, folder->path()).string();
  }
  return robots;
}

TEST(ReadSuite, TakesPathsFromTheFolderOfTheList) {
  Diagnostics diagnostics;
  const auto robots = read_lines("# arms\n\n  a.urdf a.yaml\n../b.urdf\tb.yaml\n", diagnostics);
  ASSERT_TRUE(robots);
  ASSERT_EQ(robots->size(), 2U);
  EXPECT_EQ(robots->front().urdf, "a.urdf");
  EXPECT_EQ(robots->back().urdf, "../b.urdf");
  EXPECT_EQ(robots->back().scene, "b.yaml");
}

TEST(ReadSuite, NamesTheLineOfAFault) {
  for (const char* line : {"a.urdf", "a.urdf a.yaml more"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(read_lines(std::string("# one\n") + line + "\n", diagnostics));
    ASSERT_FALSE(diagnostics.list().empty());
    EXPECT_EQ(diagnostics.list().front().line, 2);
  }
  Diagnostics diagnostics;
  EXPECT_FALSE(read_lines("# nothing\n", diagnostics));
  EXPECT_THAT(to_string(diagnostics.list().front()), HasSubstr("names no robot"));
}

BenchRow row_of(VariantGroup group, const std::string& name, double nanoseconds) {
  BenchRow row;
  row.variant.group = group;
  row.variant.name = name;
  row.timing.nanoseconds = nanoseconds;
  return row;
}

std::vector<BenchReport> two_robots() {
  std::vector<BenchReport> reports(2);
  reports[0].name = "arm";
  reports[0].functions.push_back(
      {Function::gravity,
       {row_of(VariantGroup::emitted, "double", 20), row_of(VariantGroup::language, "C99", 21),
        row_of(VariantGroup::route, "other", 1), row_of(VariantGroup::peer, "slow", 300),
        row_of(VariantGroup::peer, "quick", 130), row_of(VariantGroup::peer, "recorded", 90)}});
  reports[0].functions.back().rows.back().variant.recorded = true;
  reports[1].name = "gripper";
  reports[1].no_peers = "the robot has joints that mimic others";
  reports[1].functions.push_back(
      {Function::gravity, {row_of(VariantGroup::emitted, "double", 10)}});
  return reports;
}

TEST(CompareToBest, TakesTheFastestPeer) {
  const auto reports = two_robots();
  const auto results = compare_to_best(reports);
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].best->variant.name, "quick");
  EXPECT_EQ(results[0].recorded->variant.name, "recorded");
  EXPECT_EQ(results[0].in_c->variant.name, "C99");
  EXPECT_EQ(results[1].best, nullptr);
  EXPECT_EQ(results[1].recorded, nullptr);
}

TEST(PrintSuiteTable, SaysHowManyTimesAsLongAPeerTakesAndWhoHasNone) {
  const std::string table = print_table(two_robots());
  EXPECT_THAT(table, HasSubstr("6.5"));
  EXPECT_THAT(table, HasSubstr("4.5"));
  EXPECT_THAT(table, HasSubstr("none has it"));
  EXPECT_THAT(table, HasSubstr("gripper: no peers, the robot has joints that mimic others"));
}

TEST(DrawSuite, HasADotForEachRobotThatHasAPeer) {
  const std::string svg = draw_svg(two_robots());
  EXPECT_THAT(svg, HasSubstr("arm, gravity: 6.5 times, quick"));
  EXPECT_EQ(svg.find("gripper, gravity"), std::string::npos);
}

}  // namespace
}  // namespace treeline
