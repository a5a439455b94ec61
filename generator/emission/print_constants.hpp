#pragma once

#include <span>
#include <string>

#include "emission/adapt.hpp"

namespace treeline {

/// An integer that has a name in emitted code.
struct Constant {
  const char* name;  ///< in capitals and without the robot's: `UNKNOWNS`
  int value;
  const char* comment;  ///< may be empty
};

/// Enumerators in C, constants in C++.
std::string print_constants(const Adaptation& own, std::span<const Constant> constants);

}  // namespace treeline
