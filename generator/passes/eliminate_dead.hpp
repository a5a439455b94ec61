#pragma once

#include "program/program.hpp"

namespace treeline {

/// Removes the nodes that no result needs. The others keep their order.
Program eliminate_dead(const Program& program);

}  // namespace treeline
