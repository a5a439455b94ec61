#pragma once

#include "mechanism/mechanism.hpp"
#include "program/link_loops.hpp"

namespace treeline {

/// The table of the robot's links, the same for all functions if `mechanism` is, over which
/// functions loop; with its operational points and their rows on demand.
LinkTableData make_link_table(const Mechanism& mechanism, bool with_points);

}  // namespace treeline
