#pragma once

#include <Eigen/Core>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace treeline {

/// Units in which the inertia of a link is written, for finding how the energies of a mechanism
/// depend on the inertias. An inertia is ten numbers, those of its pseudo-inertia [Sigma h; h^T m]
/// about `centre`: m, h, Sigma_xx yy zz, sqrt(2) Sigma_xy xz yz, with sqrt(2) h, in units of `mass`
/// and `length`. So the norm of the numbers is the norm of the matrix.
struct BodyFrame {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< in the link's frame
  double mass = 1, length = 1;
};

inline constexpr int kInertialNumbers = 10;

/// Finds the combinations of all links' numbers on which the motion depends: the base inertial
/// parameters up to a change of basis. They come from the energies of random motions. Returns an
/// orthonormal basis as columns. Kinetic energy in any motion and differences of potential energy
/// depend only on the products of the numbers with these columns.
Eigen::MatrixXd find_felt_directions(const Mechanism& mechanism,
                                     const std::vector<BodyFrame>& frames);

}  // namespace treeline
