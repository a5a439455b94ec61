#pragma once

#include "program/program.hpp"

namespace treeline {

/// The program without the nodes that no result needs; the order of the others is kept.
Program eliminate_dead(const Program& program);

}  // namespace treeline
