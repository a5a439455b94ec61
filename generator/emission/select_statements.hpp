#pragma once

#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Whether the value of each node is given a statement and a name. The others, used once and
/// unnamed, are written inside the expression that uses them, as long as that stays readable;
/// constants and inputs are written where they are used.
std::vector<bool> select_statements(const Program& program);

}  // namespace treeline
