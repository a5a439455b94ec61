#include "target/executes.hpp"

#include <string_view>

namespace treeline {

bool executes([[maybe_unused]] const Target& target) {
#if defined(__x86_64__) && defined(__GNUC__)
  // The levels of the x86-64 psABI, by those of their features that lanes and products use.
  const std::string_view name = target.name;
  __builtin_cpu_init();
  const bool v3 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("bmi2") != 0 &&
                  __builtin_cpu_supports("fma") != 0;
  if (name == "x86-64-v3") return v3;
  if (name == "x86-64-v4") {
    return v3 && __builtin_cpu_supports("avx512f") != 0 &&
           __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512cd") != 0 &&
           __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0;
  }
#endif
  return false;
}

}  // namespace treeline
