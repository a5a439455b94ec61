#pragma once

#include <cstddef>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace treeline {

/// Virtual linkage of the grasps of an object (Williams & Khatib 1993), as two constant matrices in
/// the object's axes. They relate forces of the grasps [f_1; m_1; f_2; m_2; ...], which act on the
/// object at the grasps' points, to [resultant; internal], where the resultant is about the
/// object's origin. N grasps have 6 (N - 1) internal forces. A tension is positive if it would
/// stretch the object.
///  N = 2: x from grasp 1 to grasp 2, y = up x x where up is the object's z axis (its x axis if
///    |x_z| > 0.9), z = x x y: [tension; torsion (m_2 - m_1).x / 2; m_1.y; m_1.z; m_2.y; m_2.z];
///  N >= 3: three forces for 1, 2, 3 and for each further grasp, see `list_linkage_forces`; then
///    the moments m_1 .. m_N, three each in the object's axes.
struct VirtualLinkage {
  using Matrix = Eigen::Matrix<Digits50, Eigen::Dynamic, Eigen::Dynamic>;
  Matrix split;  ///< W^-1, 6 N x 6 N: from [resultant; internal] to forces of the grasps
  Matrix read;   ///< lower rows of W, 6 (N - 1) x 6 N: from forces of the grasps to internal forces
};

/// One internal force between three grasps or more: the tension of a rod, or a warp, which is the
/// force at a grasp along the normal (r_2 - r_1) x (r_3 - r_1) of the first three, where these bear
/// its reaction.
struct LinkageForce {
  enum class Kind { tension, warp };
  Kind kind = Kind::tension;
  std::size_t from = 0, to = 0;  ///< grasps at the rod's ends; a warp acts at `to`
};

/// Lists the internal forces between three grasps or more, but for their moments: the rods 12, 23,
/// 31, then of each further grasp k the rods 1k, 2k, 3k. Rods in one plane cannot bear what warps
/// it: where k lies in the plane of 1, 2, 3 (the edges of the flat tetrahedron span less than a
/// hundredth of a cube), it has two rods, to the two of 1, 2, 3 that it sees nearest to a right
/// angle, and a warp.
std::vector<LinkageForce> list_linkage_forces(const std::vector<Digits50Vector3>& points);

/// Makes the linkage of grasps at `points` in the object's frame. The points must not coincide, nor
/// the first three lie on a line.
VirtualLinkage virtual_linkage(const std::vector<Digits50Vector3>& points);

}  // namespace treeline
