#include "description/find_function.hpp"

#include <span>

namespace treeline {

std::vector<Function> every_function() {
  std::vector<Function> every;
  const auto append = [&](std::span<const Function> functions) {
    for (const Function function : functions) every.push_back(function);
  };
  append(kAllFunctions);
  append(kContactFunctions);
  append(kObjectFunctions);
  append(kPostureFunctions);
  append(kDerivativeFunctions);
  return every;
}

std::optional<Function> find_function(std::string_view name) {
  for (const Function function : every_function()) {
    if (name == function_name(function)) return function;
  }
  return std::nullopt;
}

}  // namespace treeline
