#pragma once

#include <vector>

#include "mechanism/mechanism.hpp"

namespace treeline {

/// The virtual linkage of the grasps of an object (Williams & Khatib 1993) as two constant matrices
/// in the object's axes. [resultant; internal] with the resultant about the object's origin; forces
/// of the grasps as [f_1; m_1; f_2; m_2; ...] on the object at the grasps' points. The 6 (N - 1)
/// internal forces of N grasps, a tension being positive when it would stretch the object:
///   N = 2: x from grasp 1 to grasp 2, y = up x x with up the object's z axis (its x axis where
///     |x_z| > 0.9), z = x x y: [tension; torsion (m_2 - m_1).x / 2; m_1.y; m_1.z; m_2.y; m_2.z];
///   N >= 3: tensions of the rods 12, 23, 31, then 1k, 2k, 3k of each further grasp k; then the
///     moments m_1 .. m_N, three each in the object's axes.
struct VirtualLinkage {
  using Matrix = Eigen::Matrix<Exact, Eigen::Dynamic, Eigen::Dynamic>;
  Matrix split;  ///< W^-1, 6 N x 6 N: forces of the grasps from [resultant; internal]
  Matrix read;   ///< the lower rows of W, 6 (N - 1) x 6 N: internal forces from those of the grasps
};

/// `points`: the grasps in the object's frame; not at one place, on a line or in a plane where the
/// definition needs more.
VirtualLinkage virtual_linkage(const std::vector<ExactVector3>& points);

}  // namespace treeline
