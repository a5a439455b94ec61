#pragma once

#include "program/program.hpp"

namespace treeline {

/// Puts the live nodes into the order in which they are computed: first all angles, then their
/// sines and cosines side by side (evaluated together, in lanes), then depth-first from the
/// results, starting with the operand that needs more registers. So a value is computed shortly
/// before its use, and one limb is finished, outward and inward, before the next begins. The order
/// of tracing would compute all limbs outward first and keep every intermediate value alive until
/// the way back. At last neighbours are interleaved, see `interleave`.
Program schedule(const Program& program);

}  // namespace treeline
