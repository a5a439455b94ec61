#include "description/default_base.hpp"

#include "description/check_motion.hpp"
#include "description/count_freedoms.hpp"

namespace treeline {

Base default_base(const Robot& robot) {
  const bool moves = !find_freedoms(robot, Scene{}).empty();
  return moves || !moves_inertia(robot) ? Base::fixed : Base::floating;
}

}  // namespace treeline
