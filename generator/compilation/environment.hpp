#pragma once

#include <string>

namespace treeline {

/// The value of an environment variable; empty where it is blank or not set.
std::string environment_value(const char* variable);

}  // namespace treeline
