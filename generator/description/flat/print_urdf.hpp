#pragma once

#include <string>

#include "description/flat/flat_model.hpp"

namespace treeline {

/// The mechanism as a URDF. A link whose joint is not at its origin hangs on a frame without mass,
/// `JOINT_frame`, so that both frames are where SDF has them; joints with two axes become two,
/// `JOINT_1` and `JOINT_2`; what closes a loop is a `<loop_joint>`.
std::string print_urdf(const FlatModel& model, const FlatTree& tree);

}  // namespace treeline
