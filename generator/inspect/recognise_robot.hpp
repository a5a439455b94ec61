#pragma once

#include <string>
#include <vector>

#include "description/group_bodies.hpp"
#include "inspect/end_names.hpp"

namespace treeline {

inline constexpr int kJointsOfAnArm = 3;  ///< at least, before a hand

/// Bodies in series from a branch of the tree, or from the root, to an end. Fingers belong to the
/// hand that carries them if a limb of three or more joints does.
struct Limb {
  int first = 0, last = 0;  ///< indices of bodies; `last` is the hand where there is one
  bool carries_fingers = false;
  bool is_side_branch = false;  ///< of another limb: a joint or two on the way, or half of a leg
  int joints = 0;
  int masses = 0;    ///< bodies with mass: one alone that moves in several ways is no arm
  double reach = 0;  ///< from the first joint to the tip at q = 0, m
  Eigen::Vector3d start = Eigen::Vector3d::Zero(), tip = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();  ///< of the first joint
  LimbRole role = LimbRole::unknown;
};

/// The kind of a robot, by its shape first and by names where the shape does not tell.
struct RecognisedRobot {
  std::string kind;  ///< `a quadruped`
  bool floats = false;
  std::string reason;  ///< why it floats or does not
  std::string prefix;  ///< of all names, if it tells what the whole is, see `prefix_of_all`
  int base = 0;        ///< body that limbs start from: the root's, or the one that the file floats
  std::vector<Limb> limbs;
};

RecognisedRobot recognise_robot(const Robot& robot, const BodyTree& tree);

/// Marks the second of two limbs that are halves of one leg as its side branch: of eight legs or
/// more, each turns about the line of its nearest neighbour, which is far nearer than the others,
/// as the two motors of each leg of a Minitaur. Files leave out where such halves meet.
void mark_half_legs(std::vector<Limb>& limbs);

/// Says of what kind a robot with these limbs is and whether it floats, and why. `base` is the body
/// that the limbs start from.
void name_kind(const Robot& robot, const Body& base, RecognisedRobot& found);

}  // namespace treeline
