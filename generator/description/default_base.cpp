#include "description/default_base.hpp"

#include "description/check_motion.hpp"
#include "description/count_freedoms.hpp"

namespace treeline {

Base default_base(const Robot& robot) {
  if (robot.hints.floats) return Base::floating;
  const bool moves = !find_freedoms(robot, Scene{}).empty();
  return moves || !moves_inertia(robot) ? Base::fixed : Base::floating;
}

const char* why_floating(const Robot& robot) {
  return robot.hints.floats ? "the file says so" : "no joint moves";
}

}  // namespace treeline
