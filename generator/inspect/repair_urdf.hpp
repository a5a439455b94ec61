#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "inspect/text_edit.hpp"

namespace treeline {

/// A link with the inertia that it is to have.
struct InertiaRepair {
  int link = -1;  ///< index into Robot::links
  Inertial inertial;
};

/// What to change in the URDF's text, in order of place: the values of those moments that differ
/// from the robot's, and nothing else. `text` must be that which `robot` was read from.
std::vector<TextEdit> edit_inertias(const Robot& robot, const std::string& text,
                                    const std::vector<InertiaRepair>& repairs);

/// Whether `text`, read anew, is `robot` with these inertias: that edits met their places.
bool has_repairs(const std::string& text, const Robot& robot,
                 const std::vector<InertiaRepair>& repairs);

}  // namespace treeline
