#pragma once

#include <optional>
#include <string>

#include "description/group_bodies.hpp"

namespace treeline {

/// Kind of a link according to the last meaningful word of its name (`left_hand_link`: hand); words
/// that stand for a tool's point alone count anywhere (`ee_gripper_link`).
enum class EndKind {
  tool,       ///< tcp, tool0, ee_link
  hand,       ///< hand, palm, gripper, flange
  foot,       ///< foot, sole
  tip,        ///< fingertip
  other,      ///< no known word
  wheel,      ///< wheel, roller
  propeller,  ///< prop, rotor
  watching    ///< head, camera: moves, but does not touch anything
};

struct EndName {
  EndKind kind = EndKind::other;
  int rank = 0;  ///< among names of one kind; the lowest is the best
};

EndName end_name(const std::string& link);

/// Whether the last word of a name is one of a hand, not of a gripper: `left_hand_link`.
bool is_hand(const std::string& link);

/// What a limb is for.
enum class LimbRole { unknown, finger, watching, leg, arm, wheel, propeller, surface, trunk };

/// The role that any word in the name of a link or joint tells (`left_knee_pitch`: leg). Of several
/// words, the first role in the order of `LimbRole` wins: a finger of a hand is a finger.
LimbRole limb_word(const std::string& name);

/// The word in a name that says that a robot flies or swims, if there is one (`flying_arm_2`).
std::optional<std::string> word_of_flight(const std::string& name);

/// Whether a word in a name is one of furniture, as `sink_drawer_handle`.
bool is_furniture(const std::string& name);

/// Whether a word in a link's name says that it measures, as `left_hand_force_torque` does.
bool is_sensor(const std::string& link);

/// What the names of nearly all links that move begin with, if that ends with a word of hands or
/// feet: it tells what the whole is and nothing of its limbs (`left_hand_index_1`).
std::string prefix_of_all(const Robot& robot, const BodyTree& tree);

/// Whether a link of this name is one to which robots are fixed: `world`, `ground_link`.
bool is_ground(const std::string& link);

}  // namespace treeline
