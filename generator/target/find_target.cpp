#include <algorithm>
#include <string_view>

#include "target/executes.hpp"
#include "target/target.hpp"

namespace treeline {

const Target* find_target(std::string_view name) {
  const auto targets = all_targets();
  const auto found = std::find_if(targets.begin(), targets.end(),
                                  [&](const Target& target) { return target.name == name; });
  return found == targets.end() ? nullptr : &*found;
}

bool is_particular(const Target& target) {
  return &target != &all_targets().front();
}

int choose_lanes(const Target& target, int bytes_of_real) {
  constexpr int kMost = 8;
  if (!is_particular(target)) return kMost;
  return std::clamp(target.vector_bytes / bytes_of_real, 1, kMost);
}

const OperationCosts& operation_costs(const Target& target, int bytes_of_real) {
  return bytes_of_real > 4 ? target.double_costs : target.float_costs;
}

const CodeSizes& code_sizes(const Target& target, int bytes_of_real) {
  return bytes_of_real > 4 ? target.double_sizes : target.float_sizes;
}

bool emulates(const Target& target, int bytes_of_real) {
  return target.unit == FloatUnit::none ||
         (target.unit == FloatUnit::single_only && bytes_of_real > 4);
}

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
