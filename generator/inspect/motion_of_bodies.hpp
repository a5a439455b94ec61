#pragma once

#include <Eigen/Core>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace treeline {

/// How the energies of a mechanism depend on the inertias of its links, found from random motions.
/// The inertia of each link is ten numbers, those of its pseudo-inertia [Sigma h; h^T m] about
/// `Frame::centre`: m, h, Sigma_xx yy zz, sqrt(2) Sigma_xy xz yz, with sqrt(2) h, in units of
/// `Frame::mass` and `Frame::length`, so that their norm is that of the matrix.
struct BodyFrame {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< in the link's frame
  double mass = 1, length = 1;
};

inline constexpr int kInertialNumbers = 10;

/// An orthonormal basis, as columns, of what the motion can feel of all links' numbers: the base
/// inertial parameters, up to a change of basis. Kinetic energy in any motion and differences of
/// potential energy depend on the numbers' products with these columns and on nothing else.
Eigen::MatrixXd find_felt_directions(const Mechanism& mechanism,
                                     const std::vector<BodyFrame>& frames);

}  // namespace treeline
