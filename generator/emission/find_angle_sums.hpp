#pragma once

#include <string>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Finds names of nodes that are the sine or cosine of a sum of joint angles, as roboticists write
/// them: `s23` for s2 c3 + c2 s3, `minus_c23`, `s2_minus_3`. Links with numbers of two digits are
/// kept apart: `c9_plus_10`. Empty for all other nodes, and for sines of one angle.
std::vector<std::string> find_angle_sums(const Program& program);

}  // namespace treeline
