#include "machine.hpp"

#include <unistd.h>

#include <array>
#include <fstream>

namespace treeline::bench {
namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

std::string cache_sizes() {
  constexpr std::array<std::pair<const char*, int>, 4> kLevels{{{"L1i ", _SC_LEVEL1_ICACHE_SIZE},
                                                                {", L1d ", _SC_LEVEL1_DCACHE_SIZE},
                                                                {", L2 ", _SC_LEVEL2_CACHE_SIZE},
                                                                {", L3 ", _SC_LEVEL3_CACHE_SIZE}}};
  std::string text;
  for (const auto& [name, key] : kLevels) text += name + std::to_string(sysconf(key) / 1024);
  return text + " KiB";
}

}  // namespace

Machine describe_machine() {
  return {processor_name(), cache_sizes(), measure_limits()};
}

}  // namespace treeline::bench
