#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "inspect/text_edit.hpp"

namespace treeline {

/// A link and the inertia that it shall have.
struct InertiaRepair {
  int link = -1;  ///< index into Robot::links
  Inertial inertial;
};

/// Returns the edits of the URDF's text, in order of place: the values of those moments that differ
/// from the robot's, and nothing else. `text` must be the one from which `robot` was read.
std::vector<TextEdit> edit_inertias(const Robot& robot, const std::string& text,
                                    const std::vector<InertiaRepair>& repairs);

/// Whether `text`, when it is read again, gives `robot` with these inertias, so that the edits are
/// at the right places.
bool has_repairs(const std::string& text, const Robot& robot,
                 const std::vector<InertiaRepair>& repairs);

}  // namespace treeline
