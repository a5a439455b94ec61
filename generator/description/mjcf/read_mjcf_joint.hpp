#pragma once

#include <optional>

#include "description/flat/flat_model.hpp"
#include "description/mjcf/mjcf_compiler.hpp"
#include "description/mjcf/read_geom.hpp"
#include "description/robot.hpp"

namespace treeline {

/// A joint of a body, without its links.
struct MjcfJoint {
  FlatJoint joint;
  Eigen::Isometry3d place;       ///< of its anchor in the body, whose axes it has
  Eigen::Isometry3d moved_back;  ///< what its coordinate 0 makes of `place`, for `ref` is 0 there
  double ref = 0;
  std::optional<SpringHint> spring;
};

/// Warns of attributes of a joint that add forces and have no place here: `springdamper`, and those
/// of a joint of six or three freedoms, which does not have one axis.
void warn_of_forces(const MjcfElement& element, bool has_axis);

/// Reads a `<joint>` or `<freejoint>` that stands in a `<frame>` of the body. What URDF has no
/// place for is a warning.
MjcfJoint read_mjcf_joint(const MjcfElement& element, const Eigen::Isometry3d& frame,
                          const MjcfCompiler& compiler);

/// Reads `<inertial>`.
FlatInertial read_inertial(const MjcfElement& element, const MjcfCompiler& compiler);

/// The inertia of all that geoms weigh; nothing where that is nothing.
std::optional<FlatInertial> inertial_of(const MjcfMass& mass);

/// Changes the inertia of a body, also of one without mass, as `boundmass`, `boundinertia` and
/// `balanceinertia` say, with a note.
void bound_inertial(const MjcfElement& body, const MjcfCompiler& compiler,
                    std::optional<FlatInertial>& bounded);

void scale_inertial(double factor, FlatInertial& inertial);

}  // namespace treeline
