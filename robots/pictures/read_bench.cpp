#include "read_bench.hpp"

#include <fmt/core.h>

#include <fstream>
#include <sstream>

namespace treeline::pictures {
namespace {

/// Reads a line of a table: a mark or none, time, ratio, three norm-wise and three component-wise
/// errors, operations or none, variant. Returns false for any other line.
bool read_line(const std::string& text, BenchLine& line) {
  const std::size_t begin = text.find_first_not_of(" *");
  if (begin == std::string::npos) return false;
  std::istringstream words(text.substr(begin));
  double ratio = 0.0;
  double median = 0.0;
  double most = 0.0;
  double componentwise[3];
  words >> line.nanoseconds >> ratio >> median >> most >> line.worst;
  for (double& error : componentwise) words >> error;
  if (!words) return false;
  std::getline(words >> std::ws, line.variant);
  const std::size_t end = line.variant.find_first_not_of("0123456789");
  if (end != 0 && end != std::string::npos)
    line.variant.erase(0, line.variant.find_first_not_of(' ', end));
  return !line.variant.empty();
}

}  // namespace

BenchReport read_bench(const std::string& path, std::string& error) {
  std::ifstream file(path);
  BenchReport report;
  bool after_blank = false;
  for (std::string text; std::getline(file, text); after_blank = text.empty()) {
    BenchLine line;
    if (report.robot.empty()) {
      report.robot = text.substr(0, text.find(':'));
    } else if (after_blank) {
      report.tables.push_back({text.substr(0, text.find(',')), {}});
    } else if (report.tables.empty()) {
      report.machine.push_back(text);
    } else if (read_line(text, line)) {
      report.tables.back().lines.push_back(line);
    }
  }
  if (report.tables.empty()) error = fmt::format("{}: this is no report of treeline bench", path);
  return report;
}

}  // namespace treeline::pictures
