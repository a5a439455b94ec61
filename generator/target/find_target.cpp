#include <algorithm>

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

}  // namespace treeline
