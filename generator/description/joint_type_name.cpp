#include "description/robot.hpp"

namespace treeline {

const char* joint_type_name(JointType type) {
  switch (type) {
    case JointType::revolute:
      return "revolute";
    case JointType::continuous:
      return "continuous";
    case JointType::prismatic:
      return "prismatic";
    case JointType::fixed:
      return "fixed";
    case JointType::floating:
      return "floating";
    case JointType::planar:
      return "planar";
  }
  return "";
}

}  // namespace treeline
