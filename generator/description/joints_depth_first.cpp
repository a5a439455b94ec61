#include "description/joints_depth_first.hpp"

namespace treeline {

std::vector<int> joints_depth_first(const Robot& robot) {
  std::vector<std::vector<int>> leaving(robot.links.size());  // joints of each link, the last first
  for (std::size_t j = robot.joints.size(); j-- > 0;) {
    leaving[static_cast<std::size_t>(robot.joints[j].parent)].push_back(static_cast<int>(j));
  }
  std::vector<int> order;
  std::vector<int> next = leaving[static_cast<std::size_t>(robot.root)];
  while (!next.empty()) {
    const int joint = next.back();
    next.pop_back();
    order.push_back(joint);
    const auto child =
        static_cast<std::size_t>(robot.joints[static_cast<std::size_t>(joint)].child);
    next.insert(next.end(), leaving[child].begin(), leaving[child].end());
  }
  return order;
}

}  // namespace treeline
