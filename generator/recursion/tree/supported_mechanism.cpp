#include "recursion/tree/supported_mechanism.hpp"

#include <algorithm>
#include <utility>

namespace treeline {
namespace {

/// Indices of the operational points, the most important first.
std::vector<std::size_t> point_order(const Mechanism& mechanism) {
  const auto& points = mechanism.operational_points;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&points](std::size_t a, std::size_t b) {
    return points[a].priority < points[b].priority;
  });
  return order;
}

}  // namespace

Mechanism with_constraints_only(Mechanism mechanism) {
  mechanism.operational_points = mechanism.constraints;
  return mechanism;
}

Mechanism with_supports(Mechanism mechanism) {
  std::vector<MechanismPoint> points = mechanism.constraints;
  std::vector<std::size_t> places(mechanism.operational_points.size());
  for (const std::size_t i : point_order(mechanism)) {
    places[i] = points.size();
    points.push_back(mechanism.operational_points[i]);
    points.back().priority = 1;
  }
  for (MechanismTool& tool : mechanism.inputs.tools) tool.point = places[tool.point];
  for (std::size_t& point : mechanism.inputs.active_tasks) point = places[point];
  mechanism.operational_points = std::move(points);
  return mechanism;
}

std::vector<std::size_t> task_row_order(const Mechanism& mechanism) {
  std::vector<std::size_t> first;
  std::size_t rows = 0;
  for (const MechanismPoint& point : mechanism.operational_points) {
    first.push_back(rows);
    rows += static_cast<std::size_t>(point.row_count());
  }
  std::vector<std::size_t> order;
  for (const std::size_t i : point_order(mechanism)) {
    const auto count = static_cast<std::size_t>(mechanism.operational_points[i].row_count());
    for (std::size_t row = 0; row < count; ++row) order.push_back(first[i] + row);
  }
  return order;
}

}  // namespace treeline
