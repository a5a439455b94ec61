#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// A table: `declared[n] = {entries};`, with what stands before the name in `declared`. Arrays have
/// at least one entry: 0, which nothing reads.
std::string print_table(const std::string& declared, std::vector<std::string> entries,
                        std::size_t indentation);

/// A header of sizes, where `header` has TL_CONSTANTS in their place and TL_CONTRACT for the name
/// of the robot's header.
std::string print_sizes(const std::string& robot, const Adaptation& own, std::string_view header,
                        std::span<const Constant> sizes);

}  // namespace treeline
