#pragma once

#include "program/ending.hpp"
#include "recursion/routes/trace.hpp"

namespace treeline {

/// Whether functions of the tree may be computed in one common frame, see
/// `runtime/emitted/common_frame.h`: joints have one freedom of their own each and are numbered
/// depth first, a base may float, and inertias are constants.
bool suits_common_frame(const Tree<Expression>& tree);

/// M by lines for the links' places and a routine for the rest. Joints' rotations are not deferred
/// in the trace.
Ending end_with_mass_matrix(const Trace& trace);

/// Derivatives of joint forces, likewise. No forces act at points.
Ending end_with_force_derivatives(const Trace& trace);

/// Derivatives of accelerations, likewise.
Ending end_with_acceleration_derivatives(const Trace& trace);

}  // namespace treeline
