#include "machine.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
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

#if defined(__x86_64__)
/// Seconds for a hundred thousand dependent multiplications, three cycles each on every x86-64 core
/// since 2008.
double seconds_of_chain() {
  std::uint64_t x = 3;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 10000; ++i) {
    asm volatile(".rept 10\n imul %0, %0\n .endr\n" : "+r"(x));
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
#endif

double measured_gigahertz() {
#if defined(__x86_64__)
  double best = 1;
  for (int i = 0; i < 20; ++i) best = std::min(best, seconds_of_chain());
  return 3e5 / best * 1e-9;
#else
  return 0;
#endif
}

}  // namespace

Machine describe_machine() {
  return {processor_name(), cache_sizes(), measured_gigahertz()};
}

}  // namespace treeline::bench
