#include <algorithm>

#include "peers.hpp"
#include "pinocchio/description.hpp"

namespace treeline::bench {
namespace {

/// Nothing for a point with other rows or axes than Pinocchio's routes are written for here.
bool describe(const Case& robot, const interpreter::OperationalPoint<double>& point,
              std::vector<pin::Point>& points) {
  if (point.axes != interpreter::PointAxes::world) return false;
  if (std::ranges::find(point.rows, false) != point.rows.end()) return false;
  pin::Point described{robot.model.body(point.body).name, {}, {}};
  for (int i = 0; i < 3; ++i) {
    described.p[static_cast<std::size_t>(i)] = point.p(i);
    for (int k = 0; k < 3; ++k) described.R[static_cast<std::size_t>(3 * i + k)] = point.R(i, k);
  }
  points.push_back(described);
  return true;
}

}  // namespace

std::vector<Subject> pinocchio_subjects(const Case& robot) {
  const auto& g = robot.model.gravity;
  pin::Description description{robot.urdf, robot.floating, robot.joints, {g(0), g(1), g(2)}, {}};
  const bool all = std::ranges::all_of(
      robot.points, [&](const auto& point) { return describe(robot, point, description.points); });
  if (!all) description.points.clear();
  return pin::pinocchio_subjects(description);
}

}  // namespace treeline::bench
