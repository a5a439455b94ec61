#include "compilation/environment.hpp"

#include <cstdlib>

#include "compilation/run_commands.hpp"

namespace treeline {

std::string environment_value(const char* variable) {
  const char* const value = std::getenv(variable);
  return value == nullptr || split_words(value).empty() ? "" : value;
}

}  // namespace treeline
