#include "timing/describe_processor.hpp"

#include <algorithm>
#include <fstream>

namespace treeline {

std::string describe_processor() {
  std::ifstream file("/proc/cpuinfo");
  std::string model;
  std::string family;
  for (std::string line; std::getline(file, line) && !line.empty();) {
    const auto value = [&] { return line.substr(std::min(line.find(':') + 2, line.size())); };
    if (line.starts_with("model name")) model = value();
    if (line.starts_with("cpu family")) family = value();
  }
  if (model.empty()) return "an unnamed processor";
  return family.empty() ? model : model + ", family " + family;
}

}  // namespace treeline
