#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mechanism/build_mechanism.hpp"

namespace treeline {
namespace {

// q + offset is rounded according to its size: up to this angle by at most two ulp of a sine's
// scale.
constexpr double kFarthest = 8;  // rad

bool may_round(const Mechanism& mechanism, const MovingLink& link, Accuracy accuracy) {
  return accuracy == Accuracy::fastest ||
         (accuracy == Accuracy::balanced && largest_angle(mechanism, link) <= kFarthest);
}

}  // namespace

double largest_angle(const Mechanism& mechanism, const MovingLink& link) {
  const Coordinate& q = mechanism.coordinates[static_cast<std::size_t>(link.q_index)];
  return std::max(std::abs(q.lower), std::abs(q.upper)) * std::abs(link.multiplier) +
         std::abs(static_cast<double>(link.offset));
}

void keep_angles(Mechanism& mechanism, Accuracy accuracy) {
  for (MovingLink& link : mechanism.links) {
    if (!link.turns_by_angle() || link.offset == 0) continue;
    const auto offset = static_cast<double>(link.offset);
    if (may_round(mechanism, link, accuracy)) {
      mechanism.notes.push_back(
          {"place", link.name,
           fmt::format("angle offset by {:.6g} rad inside the recursions", offset)});
      continue;
    }
    link.placement =
        resolved(link.placement * Digits50Pose{rotation_z(link.offset), Digits50Vector3::Zero()},
                 mechanism.resolution);
    link.offset = 0;
    mechanism.notes.push_back(
        {"place", link.name,
         fmt::format("turned on by {:.6g} rad by the theorem of addition: q + offset would be "
                     "rounded as a large angle is",
                     offset)});
  }
}

}  // namespace treeline
