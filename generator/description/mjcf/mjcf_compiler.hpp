#pragma once

#include <Eigen/Geometry>
#include <string>

#include "description/mjcf/mjcf_element.hpp"

namespace treeline {

/// What `<compiler>` says of how the model is to be read.
struct MjcfCompiler {
  double angle = 0.017453292519943295;  ///< rad, of one unit in which the file has angles
  std::string eulerseq = "xyz";
  bool autolimits = true;
  std::string inertiafromgeom = "auto";
  int first_group = 0, last_group = 5;  ///< of geoms whose inertia counts
  double boundmass = 0, boundinertia = 0, settotalmass = 0;
  bool balanceinertia = false, strippath = false;
  std::string meshdir;
};

/// Takes over what one `<compiler>` says; later ones overwrite. An error for coordinates that are
/// not local.
void read_compiler(const MjcfElement& element, MjcfCompiler& compiler);

/// `pos`, and the orientation by `quat`, `axisangle`, `euler`, `xyaxes` or `zaxis`.
Eigen::Isometry3d read_mjcf_pose(const MjcfElement& element, const MjcfCompiler& compiler);

/// The rotation of a quaternion w x y z of any length; of length zero it is the identity.
Eigen::Matrix3d rotation_from_wxyz(const double* quaternion);

/// The smallest rotation that takes z to a direction.
Eigen::Matrix3d rotation_from_z_to(const Eigen::Vector3d& direction);

/// Whether a range bounds: the attribute `limited` says so, or leaves it to whether there is one.
bool is_limited(const MjcfElement& element, const char* limited, const std::vector<double>& range,
                const MjcfCompiler& compiler);

}  // namespace treeline
