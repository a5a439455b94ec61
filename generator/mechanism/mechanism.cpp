#include "mechanism/mechanism.hpp"

#include <algorithm>
#include <numeric>

namespace treeline {

ExactMatrix3 rotation_z(const Exact& angle) {
  const Exact c = cos(angle);
  const Exact s = sin(angle);
  ExactMatrix3 R = ExactMatrix3::Identity();
  R(0, 0) = c;
  R(0, 1) = -s;
  R(1, 0) = s;
  R(1, 1) = c;
  return R;
}

ExactPose snapped(const ExactPose& pose) {
  ExactPose result = pose;
  for (int i = 0; i < 9; ++i) {
    Exact& entry = result.R(i / 3, i % 3);
    entry = snapped(entry, Exact(1));
    const Exact unit = entry < 0 ? Exact(-1) : Exact(1);
    if (snapped(Exact(entry - unit), Exact(1)) == 0) {
      entry = unit;
    }
  }
  const Exact largest =
      std::max({Exact(abs(pose.p(0))), Exact(abs(pose.p(1))), Exact(abs(pose.p(2))), Exact(1e-6)});
  for (int i = 0; i < 3; ++i) {
    result.p(i) = snapped(pose.p(i), largest);
  }
  return result;
}

Inertia transformed(const Inertia& inertia, const ExactPose& pose) {
  const ExactVector3 h = pose.R * inertia.h;
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

Inertia snapped(const Inertia& inertia) {
  const Exact Sigma_size = inertia.Sigma.cwiseAbs().maxCoeff();
  // All three numbers of a balanced body's h may be residue: mass at its radius of gyration is what
  // they cancelled from.
  const Exact balanced = sqrt(Exact(abs(inertia.mass) * Sigma_size));
  const Exact h_size = std::max(Exact(inertia.h.cwiseAbs().maxCoeff()), balanced);
  Inertia result = inertia;
  for (int i = 0; i < 3; ++i) {
    result.h(i) = snapped(inertia.h(i), h_size);
    for (int j = 0; j < 3; ++j) {
      result.Sigma(i, j) = snapped(inertia.Sigma(i, j), Sigma_size);
    }
  }
  return result;
}

ExactMatrix3 rotational_inertia(const Inertia& inertia) {
  return inertia.Sigma.trace() * ExactMatrix3::Identity() - inertia.Sigma;
}

int MechanismPoint::row_count() const {
  return static_cast<int>(std::count(rows.begin(), rows.end(), true));
}

int Mechanism::task_rows() const {
  return std::accumulate(
      operational_points.begin(), operational_points.end(), 0,
      [](int sum, const MechanismPoint& point) { return sum + point.row_count(); });
}

bool Mechanism::has_mimics() const {
  return std::any_of(links.begin(), links.end(),
                     [](const MovingLink& link) { return link.mimics; });
}

}  // namespace treeline
