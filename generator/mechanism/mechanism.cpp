#include "mechanism/mechanism.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace treeline {

Digits50Matrix3 rotation_z(const Digits50& angle) {
  const Digits50 c = cos(angle);
  const Digits50 s = sin(angle);
  Digits50Matrix3 R = Digits50Matrix3::Identity();
  R(0, 0) = c;
  R(0, 1) = -s;
  R(1, 0) = s;
  R(1, 1) = c;
  return R;
}

Inertia transformed(const Inertia& inertia, const Digits50Pose& pose) {
  const Digits50Vector3 h = pose.R * inertia.h;
  Inertia result;
  result.mass = inertia.mass;
  result.h = h + inertia.mass * pose.p;
  result.Sigma = pose.R * inertia.Sigma * pose.R.transpose() + h * pose.p.transpose() +
                 pose.p * h.transpose() + inertia.mass * pose.p * pose.p.transpose();
  return result;
}

Inertia operator+(const Inertia& a, const Inertia& b) {
  return {a.mass + b.mass, a.h + b.h, a.Sigma + b.Sigma};
}

Digits50Matrix3 rotational_inertia(const Inertia& inertia) {
  return inertia.Sigma.trace() * Digits50Matrix3::Identity() - inertia.Sigma;
}

void resolve_inertia(Mechanism& mechanism, MovingLink& link) {
  Change change;
  link.inertia = resolved(link.inertia, mechanism.resolution, &change);
  add_decisions(change, fmt::format("robot/link[{}]/inertial", link.name), mechanism.file,
                mechanism.noise);
}

bool has_center_of_mass(const Mechanism& mechanism) {
  const auto& points = mechanism.operational_points;
  return std::any_of(points.begin(), points.end(),
                     [](const MechanismPoint& point) { return point.center_of_mass; });
}

int MechanismPoint::row_count() const {
  return static_cast<int>(std::count(rows.begin(), rows.end(), true));
}

namespace {

int rows_of(const std::vector<MechanismPoint>& points) {
  return std::accumulate(points.begin(), points.end(), 0, [](int sum, const MechanismPoint& point) {
    return sum + point.row_count();
  });
}

}  // namespace

int Mechanism::task_rows() const {
  return rows_of(operational_points);
}

int Mechanism::anchored_rows() const {
  return rows_of(constraints);
}

int Mechanism::held_rows() const {
  int rows = anchored_rows() + static_cast<int>(couplings.size());
  for (const MechanismLoop& loop : loops) rows += loop.second.row_count();
  return rows;
}

bool Mechanism::has_mimics() const {
  return std::any_of(links.begin(), links.end(),
                     [](const MovingLink& link) { return link.mimics; });
}

}  // namespace treeline
