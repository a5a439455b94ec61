#include "counts.hpp"

#include <fstream>
#include <sstream>

namespace treeline::bench {

std::map<std::string, long> read_counts(const std::string& path) {
  std::map<std::string, long> counts;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    std::string robot, function;
    long count = 0;
    if (fields >> robot >> function >> count) counts[robot + '/' + function] = count;
  }
  return counts;
}

}  // namespace treeline::bench
