#include "description/group_bodies.hpp"

#include <utility>

namespace treeline {

BodyTree group_bodies(const Robot& robot) {
  std::vector<std::vector<int>> joints(robot.links.size());  // by their parents
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    joints[static_cast<std::size_t>(robot.joints[j].parent)].push_back(static_cast<int>(j));
  }
  BodyTree tree{{Body{}}, std::vector(robot.links.size(), Eigen::Isometry3d::Identity())};
  std::vector<std::pair<int, int>> stack{{robot.root, 0}};  // link and its body
  while (!stack.empty()) {
    const auto [link, body] = stack.back();
    stack.pop_back();
    tree.bodies[static_cast<std::size_t>(body)].links.push_back(link);
    const auto& own = joints[static_cast<std::size_t>(link)];
    for (auto j = own.rbegin(); j != own.rend(); ++j) {
      const Joint& joint = robot.joints[static_cast<std::size_t>(*j)];
      tree.frames[static_cast<std::size_t>(joint.child)] =
          tree.frames[static_cast<std::size_t>(link)] * isometry_of(joint.origin);
      int behind = body;
      if (joint.type != JointType::fixed) {
        behind = static_cast<int>(tree.bodies.size());
        tree.bodies[static_cast<std::size_t>(body)].children.push_back(behind);
        tree.bodies.push_back({{}, body, *j, {}});
      }
      stack.emplace_back(joint.child, behind);
    }
  }
  return tree;
}

}  // namespace treeline
