#pragma once

#include "program/program.hpp"

namespace treeline {

/// The live nodes in the order in which they are to be computed: all angles first, then their sines
/// and cosines side by side (they are evaluated together, in lanes), then depth-first from the
/// results, the operand that needs more registers first. So a value is made shortly before it is
/// used, and a limb is finished, outward and inward, before the next one begins; the tracing order
/// would do all limbs outward and keep every intermediate alive until the way back. Last,
/// neighbours are interleaved, see `interleave`.
Program schedule(const Program& program);

}  // namespace treeline
