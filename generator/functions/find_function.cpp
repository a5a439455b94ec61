#include "functions/find_function.hpp"

namespace treeline {

std::optional<Function> find_function(std::string_view name) {
  for (const Function function : kSceneFunctions) {
    if (name == function_name(function)) return function;
  }
  return std::nullopt;
}

}  // namespace treeline
