#pragma once

#include <string>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Operations that the results need. Changing the sign of a result is not counted; an angle whose
/// sine and cosine are both taken counts once.
OperationCount count_operations(const Program& program);

struct SectionCount {
  std::string title;
  OperationCount count;
};

/// The same for each section, in order of first appearance; sections of one title are one.
std::vector<SectionCount> count_sections(const Program& program);

}  // namespace treeline
