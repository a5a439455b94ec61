#include "description/find_joint.hpp"

#include <algorithm>

namespace treeline {

const Joint* find_joint(const Robot& robot, const std::string& name) {
  const auto found = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&name](const Joint& joint) { return joint.name == name; });
  return found == robot.joints.end() ? nullptr : &*found;
}

}  // namespace treeline
