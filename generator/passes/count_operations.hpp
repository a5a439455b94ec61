#pragma once

#include <string>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Counts the operations that the results need. A change of sign is not counted. An angle whose
/// sine and cosine are both needed counts once. Of loops over links it is what they execute.
OperationCount count_operations(const Program& program);

struct SectionCount {
  std::string title;
  OperationCount count;
};

/// Counts the operations that the results need, by section, in order of first appearance. Sections
/// with the same title are counted together.
std::vector<SectionCount> count_sections(const Program& program);

}  // namespace treeline
