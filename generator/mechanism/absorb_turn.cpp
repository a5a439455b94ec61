#include <algorithm>
#include <cmath>

#include "mechanism/build_steps.hpp"

namespace treeline {
namespace {

bool is_trivial(const Digits50& entry) {
  return entry == 0 || entry == 1 || entry == -1;
}

/// Number of operations to rotate a vector by a constant rotation.
int rotation_cost(const Digits50Matrix3& R) {
  int multiplications = 0;
  int terms = 0;
  for (int i = 0; i < 9; ++i) {
    const Digits50& entry = R(i / 3, i % 3);
    multiplications += is_trivial(entry) ? 0 : 1;
    terms += entry == 0 ? 0 : 1;
  }
  return multiplications + terms - 3;
}

// Number of vectors rotated and products taken per joint, in RNEA and the articulated-body
// recursions together.
constexpr int kRotationWeight = 8;
constexpr int kPositionWeight = 12;

/// Cost of the link if its placement were this one.
int placement_cost(const MovingLink& link, const Digits50Pose& placement) {
  // On a fixed base, nothing but gravity needs to be rotated, and gravity is constant.
  return link.parent < 0 ? nonzeros(placement.p) : pose_cost(placement);
}

Digits50 folded_to_quarter(const Digits50& angle) {
  return angle - half_pi() * round(angle / half_pi());
}

/// A vector in the plane that `right_turn` turns x to. It need not have unit length.
struct Direction {
  Digits50 x, y;
};
Direction right_direction(const Digits50Matrix3& R) {
  if (R(2, 0) == 0 && R(2, 1) == 0) return {R(0, 0), R(1, 0)};
  return {R(2, 1), R(2, 0)};
}

/// Whether there is a rotation about z at the end of R that a joint's angle can take.
bool has_right_turn(const Digits50Matrix3& R) {
  return is_parallel(R) ? R(0, 0) != 0 && R(1, 0) != 0 : R(2, 0) != 0 && R(2, 1) != 0;
}

/// R without the rotation about z at its end, up to quarter turns.
Digits50Matrix3 without_right_turn(const Digits50Matrix3& R) {
  const Direction towards = right_direction(R);
  const Digits50 length = sqrt(Digits50(towards.x * towards.x + towards.y * towards.y));
  const Digits50 c = towards.x / length, s = towards.y / length;
  Digits50Matrix3 result = R;
  result.col(0) = R.col(0) * c - R.col(1) * s;
  result.col(1) = R.col(0) * s + R.col(1) * c;
  return result;
}

/// Whether an angle is certainly no multiple of a quarter turn.
bool is_between_quarters(double angle) {
  constexpr double kSurely = 1e-6, kQuarter = 1.5707963267948966;
  return std::abs(std::remainder(angle, kQuarter)) > kSurely;
}

/// Whether the angle would have an offset if it took the turn at the end of R.
bool has_offset_with_turn(const MovingLink& link, const Digits50Matrix3& R,
                          const Resolution& resolution) {
  if (link.offset != 0) {
    const Direction towards = right_direction(R);
    const double about = std::atan2(static_cast<double>(towards.y), static_cast<double>(towards.x));
    if (is_between_quarters(static_cast<double>(link.offset) + about)) return true;
    const Digits50 turn = folded_to_quarter(right_turn(R));
    return resolved(Digits50(link.offset + turn), resolution) != 0;
  }
  const auto [x, y] = right_direction(R);  // from the nearest quarter turn
  const Digits50 sine = std::min(Digits50(abs(x)), Digits50(abs(y)));
  return sine * sine > resolution.angle * resolution.angle * (x * x + y * y);
}

}  // namespace

int nonzeros(const Digits50Vector3& v) {
  return (v(0) != 0 ? 1 : 0) + (v(1) != 0 ? 1 : 0) + (v(2) != 0 ? 1 : 0);
}

int pose_cost(const Digits50Pose& pose) {
  return kRotationWeight * rotation_cost(pose.R) + kPositionWeight * nonzeros(pose.p);
}

int link_cost(const MovingLink& link) {
  const int offset = link.turns_by_angle() && link.offset != 0 ? 1 : 0;
  return offset + placement_cost(link, link.placement);
}

bool is_parallel(const Digits50Matrix3& R) {
  return R(0, 2) == 0 && R(1, 2) == 0;
}

Digits50 right_turn(const Digits50Matrix3& R) {
  const Direction towards = right_direction(R);
  return atan2(towards.y, towards.x);
}

void absorb_turn(MovingLink& link, const Resolution& resolution, Change* change) {
  if (!link.turns_by_angle()) {
    return;
  }
  const Digits50Matrix3& R = link.placement.R;
  if (!has_right_turn(R)) {
    return;
  }
  const Digits50 turn = folded_to_quarter(right_turn(R));
  MovingLink absorbed = link;
  Change by_turn;
  absorbed.placement =
      resolved(link.placement * Digits50Pose{rotation_z(-turn), Digits50Vector3::Zero()},
               resolution, change ? &by_turn : nullptr);
  absorbed.offset = resolved(Digits50(link.offset + turn), resolution);
  if (link_cost(absorbed) < link_cost(link)) {
    link = absorbed;
    if (change) change->angle = std::max(change->angle, by_turn.angle);
  }
}

int absorbed_cost(const MovingLink& link, const Digits50Pose& placement,
                  const Resolution& resolution) {
  const bool turns = link.turns_by_angle();
  const int cost = placement_cost(link, placement) + (turns && link.offset != 0 ? 1 : 0);
  if (!turns || !has_right_turn(placement.R)) return cost;
  int absorbed = has_offset_with_turn(link, placement.R, resolution) ? 1 : 0;
  absorbed += link.parent < 0
                  ? nonzeros(placement.p)
                  : pose_cost(resolved({without_right_turn(placement.R), placement.p}, resolution));
  return std::min(cost, absorbed);
}

}  // namespace treeline
