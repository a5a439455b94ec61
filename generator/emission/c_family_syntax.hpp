#pragma once

#include "emission/backend/syntax.hpp"

namespace treeline {

/// What C and the languages made from it write alike: comments, literals, signs, assignments and
/// constants. Numbers, lanes and sines are left to fill in.
Syntax make_c_family_syntax(bool single_precision);

}  // namespace treeline
