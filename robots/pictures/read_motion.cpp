#include "read_motion.hpp"

#include <fmt/core.h>

#include <charconv>
#include <fstream>
#include <sstream>

namespace treeline::pictures {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

bool read_number(const std::string& text, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

Motion read_motion(const std::string& path, std::string& error) {
  std::ifstream file(path);
  std::string line;
  if (!file || !std::getline(file, line)) {
    error = fmt::format("{}: the file cannot be read", path);
    return {};
  }
  const std::vector<std::string> names = split(line);
  Motion motion;
  for (int number = 2; std::getline(file, line); ++number) {
    const std::vector<std::string> cells = split(line);
    for (std::size_t i = 0; i < names.size(); ++i) {
      double value = 0.0;
      if (cells.size() != names.size() || !read_number(cells[i], value)) {
        error = fmt::format("{}:{}: {} numbers are expected", path, number, names.size());
        return {};
      }
      motion[names[i]].push_back(value);
    }
  }
  if (motion.empty()) error = fmt::format("{}: there is no row of numbers", path);
  return motion;
}

}  // namespace treeline::pictures
