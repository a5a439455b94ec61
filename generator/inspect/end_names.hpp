#pragma once

#include <string>

namespace treeline {

/// What a link is, by the last word of its name that means anything (`left_hand_link`: hand).
enum class EndKind {
  tool,       ///< tcp, tool0, ee_link
  hand,       ///< hand, palm, gripper, flange
  foot,       ///< foot, sole
  tip,        ///< fingertip
  other,      ///< nothing that is known
  wheel,      ///< wheel, roller
  propeller,  ///< prop, rotor
  watching    ///< head, camera: moves, but works on nothing
};

struct EndName {
  EndKind kind = EndKind::other;
  int rank = 0;  ///< among names of one kind: the least is the best
};

EndName end_name(const std::string& link);

/// Whether robots are held at links of this name: `world`, `ground`.
bool is_ground(const std::string& link);

}  // namespace treeline
