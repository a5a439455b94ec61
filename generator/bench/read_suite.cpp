#include <fmt/format.h>

#include <sstream>

#include "bench/suite.hpp"
#include "text/read_text_file.hpp"

namespace treeline {

std::optional<std::vector<SuiteRobot>> read_suite(const std::filesystem::path& path,
                                                  Diagnostics& diagnostics) {
  const auto text = read_text_file(path.string(), diagnostics);
  if (!text) return std::nullopt;
  const auto fault = [&](int line, std::string what) {
    diagnostics.add({Severity::error, path, line, "", std::move(what),
                     "A line has the path of a robot and that of its scene."});
  };
  std::vector<SuiteRobot> robots;
  std::istringstream lines(*text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string urdf, scene, more;
    if (!(words >> urdf) || urdf.front() == '#') continue;
    if (!(words >> scene) || (words >> more)) {
      fault(number, fmt::format("`{}` does not have two words", line));
      continue;
    }
    const auto folder = path.parent_path();
    robots.push_back({(folder / urdf).string(), (folder / scene).string()});
  }
  if (robots.empty() && !diagnostics.has_errors()) fault(0, "names no robot");
  if (diagnostics.has_errors()) return std::nullopt;
  return robots;
}

}  // namespace treeline
