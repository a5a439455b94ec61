#pragma once

#include <set>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "recursion/algebra/row_space.hpp"

namespace treeline {

/// An inertia as a column of numbers: m, h, Sigma_xx xy xz yy yz zz, and one more for the inertia
/// of the rotor at the joint of its link.
inline constexpr int kBodyNumbers = 11;
inline constexpr int kRotorNumber = 10;

/// How the energies of a robot depend on the inertia of one link.
struct FeltMotion {
  int parent = -1;  ///< index into `Mechanism::link_frames` of the link before; -1: the world
  Digits50Pose placement;  ///< of the link in that one, all coordinates of the joint at zero
  /// Rows by `kBodyNumbers`: a basis of all that the joint of this link makes of an inertia on it.
  /// An inertia of which all of this is zero does what it would do on the link before, there
  /// transformed by `placement`.
  Digits50Rows moving;
};

/// Units and limits of the decisions.
struct FeltUnits {
  Digits50 length = 1;     ///< m
  Digits50 tolerance = 0;  ///< what rows may differ by and count as dependent
};

/// Unit of length: the longest offset of a joint or of a link's frame. Tolerance: some of the
/// mechanism's resolution, within which axes are parallel.
FeltUnits felt_units(const Mechanism& mechanism);

/// Finds, for each link of `Mechanism::link_frames`, what its joint makes felt of its inertia.
///
/// Kinetic and potential energy of an inertia on a link are linear in its numbers: rows. Outward
/// from the base, each joint makes of the rows of the link before it those of its own, for all its
/// coordinates and velocities, which are independent of those before. A coordinate turns or slides
/// the numbers by a group of one parameter, so what it makes of a row is the row times powers of
/// the group's generator, of which finitely many are independent. A velocity adds the products of
/// the joint's axis with itself and with all velocities of the link before. So the spaces of rows
/// follow from the tree and its constants, without any sample of motions. Joints that mimic others
/// count as if they moved by themselves: all that is said here holds for them too, but they may
/// make less felt. `rotors` are the links of the mechanism whose joints have a rotor that counts.
std::vector<FeltMotion> felt_motions(const Mechanism& mechanism, const FeltUnits& units,
                                     const std::set<std::size_t>& rotors);

/// The inertia whose number `k` is one, and all others zero.
Inertia unit_inertia(int k);
/// The numbers of an inertia but for the rotor's, which is zero.
Digits50Row numbers_of(const Inertia& inertia);
/// The pose with its origin in other units of length.
Digits50Pose in_units(const Digits50Pose& pose, const FeltUnits& units);

}  // namespace treeline
