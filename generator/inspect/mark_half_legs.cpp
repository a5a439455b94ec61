#include <algorithm>
#include <limits>

#include "inspect/recognise_robot.hpp"

namespace treeline {
namespace {

constexpr std::size_t kFewestHalves = 8;
constexpr double kOnOneLine = 0.01;  ///< m, and rad
constexpr double kMuchNearer = 0.7;  ///< of the distance to the next but one

/// The other half of a leg, or the leg itself where it is whole.
std::size_t half_beside(const std::vector<Limb*>& legs, std::size_t i) {
  double nearest = std::numeric_limits<double>::infinity(), next = nearest;
  std::size_t other = i;
  for (std::size_t k = 0; k < legs.size(); ++k) {
    if (k == i) continue;
    const double distance = (legs[k]->start - legs[i]->start).norm();
    if (distance < nearest) other = k;
    next = std::min(next, std::max(distance, nearest));
    nearest = std::min(nearest, distance);
  }
  const Eigen::Vector3d apart = legs[other]->start - legs[i]->start;
  const bool one_line = legs[i]->axis.cross(legs[other]->axis).norm() < kOnOneLine &&
                        legs[i]->axis.cross(apart).norm() < kOnOneLine;
  return one_line && nearest < kMuchNearer * next ? other : i;
}

}  // namespace

void mark_half_legs(std::vector<Limb>& limbs) {
  std::vector<Limb*> legs;
  for (Limb& limb : limbs) {
    if (limb.role == LimbRole::leg && !limb.is_side_branch) legs.push_back(&limb);
  }
  if (legs.size() < kFewestHalves) return;
  std::vector<std::size_t> beside;
  for (std::size_t i = 0; i < legs.size(); ++i) beside.push_back(half_beside(legs, i));
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (beside[i] == i || beside[beside[i]] != i) return;
  }
  for (std::size_t i = 0; i < legs.size(); ++i) legs[i]->is_side_branch = beside[i] < i;
}

}  // namespace treeline
