// Prints the table of docs/evidence/generated-code.md about the savings by snap_angles:
// snapping_report. Exit status: 0 printed, 1 a robot cannot be measured (named on standard error).
#include <cstdio>
#include <exception>

#include "measure_snapping.hpp"

int main() {
  using namespace treeline;  // NOLINT: a program, not a header
  std::vector<growth::Snapping> all;
  int failed = 0;
  for (const tests::DataRobot& robot : tests::data_robots("published")) {
    try {
      all.push_back(growth::measure_snapping(robot));
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s: %s\n", robot.name.c_str(), error.what());
      failed = 1;
    }
  }
  std::printf("%s", growth::print_snapping(all).c_str());
  return failed;
}
