#include "recursion/tree/virtual_linkage.hpp"

#include <Eigen/LU>

namespace treeline {
namespace {

using Vector = Eigen::Matrix<Digits50, Eigen::Dynamic, 1>;

Digits50Vector3 cross(const Digits50Vector3& a, const Digits50Vector3& b) {
  return {a(1) * b(2) - a(2) * b(1), a(2) * b(0) - a(0) * b(2), a(0) * b(1) - a(1) * b(0)};
}

Digits50Vector3 unit(const Digits50Vector3& v) {
  return v / Digits50(sqrt(Digits50(v.dot(v))));
}

/// The forces of one hand are the resultant, moved to its point.
Vector split_over_one(const std::vector<Digits50Vector3>& r, const Vector& wanted) {
  Vector forces = wanted;
  forces.tail<3>() -= cross(r[0], wanted.head<3>());
  return forces;
}

/// Half of the force each; the moment about the middle that the hands' own moments leave is borne
/// by a couple of forces across the line between them and, about the line, by both hands alike.
Vector split_over_two(const std::vector<Digits50Vector3>& r, const Vector& wanted) {
  const Digits50Vector3 arm = r[1] - r[0];
  const Digits50 length = sqrt(Digits50(arm.dot(arm)));
  const Digits50Vector3 x = arm / length;
  const bool along_z = abs(x(2)) > Digits50(9) / 10;
  const Digits50Vector3 y = unit(along_z ? cross(Digits50Vector3::UnitX(), x)  //
                                         : cross(Digits50Vector3::UnitZ(), x));
  const Digits50Vector3 z = cross(x, y);
  const Digits50Vector3 F = wanted.segment<3>(0);
  const Digits50Vector3 M = wanted.segment<3>(3) - cross(Digits50Vector3((r[0] + r[1]) / 2), F);
  const Digits50 tension = wanted(6), torsion = wanted(7), twist = M.dot(x) / 2;
  const Digits50Vector3 bend_1 = wanted(8) * y + wanted(9) * z;
  const Digits50Vector3 bend_2 = wanted(10) * y + wanted(11) * z;
  const Digits50Vector3 across = M - x * M.dot(x) - bend_1 - bend_2;
  const Digits50Vector3 couple = cross(across, x) / length;
  Vector forces(12);
  forces << F / 2 - couple - tension * x, bend_1 + (twist - torsion) * x,
      F / 2 + couple + tension * x, bend_2 + (twist + torsion) * x;
  return forces;
}

/// Whether the edges from grasp k to the first three span next to no volume.
bool is_in_plane(const std::vector<Digits50Vector3>& r, std::size_t k) {
  const Digits50 volume = unit(r[k] - r[0]).dot(cross(unit(r[k] - r[1]), unit(r[k] - r[2])));
  return abs(volume) < Digits50(1) / 100;
}

/// Appends the forces of a grasp k in the plane of the first three.
void append_in_plane(const std::vector<Digits50Vector3>& r, std::size_t k,
                     std::vector<LinkageForce>& forces) {
  const Digits50 more = Digits50(1) / 1000;  // of the square of a sine: equals keep their order
  std::size_t first = 0;
  Digits50 best = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Digits50Vector3 sine = cross(unit(r[i] - r[k]), unit(r[(i + 1) % 3] - r[k]));
    if (sine.dot(sine) > best + more) {
      best = sine.dot(sine);
      first = i;
    }
  }
  forces.push_back({LinkageForce::Kind::tension, first, k});
  forces.push_back({LinkageForce::Kind::tension, (first + 1) % 3, k});
  forces.push_back({LinkageForce::Kind::warp, 0, k});
}

/// f_i gets -e_ij t, f_j gets +e_ij t.
void add_tension(const std::vector<Digits50Vector3>& r, const LinkageForce& rod, const Digits50& t,
                 Vector& forces) {
  const Digits50Vector3 force = t * unit(r[rod.to] - r[rod.from]);
  forces.segment<3>(6 * static_cast<Eigen::Index>(rod.from)) -= force;
  forces.segment<3>(6 * static_cast<Eigen::Index>(rod.to)) += force;
}

/// f_k gets n w; each of the first three -n w times the share by which it carries k: that of the
/// triangle which k makes with the other two.
void add_warp(const std::vector<Digits50Vector3>& r, std::size_t k, const Digits50& w,
              Vector& forces) {
  const Digits50Vector3 area = cross(r[1] - r[0], r[2] - r[0]);
  const Digits50Vector3 n = unit(area);
  forces.segment<3>(6 * static_cast<Eigen::Index>(k)) += w * n;
  for (std::size_t i = 0; i < 3; ++i) {
    const Digits50Vector3 part = cross(r[(i + 1) % 3] - r[k], r[(i + 2) % 3] - r[k]);
    const Digits50 share = n.dot(part) / n.dot(area);
    forces.segment<3>(6 * static_cast<Eigen::Index>(i)) -= share * w * n;
  }
}

void add_linkage_forces(const std::vector<Digits50Vector3>& r, const Vector& wanted,
                        Vector& forces) {
  Eigen::Index at = 6;
  for (const LinkageForce& each : list_linkage_forces(r)) {
    const Digits50 size = wanted(at++);
    if (each.kind == LinkageForce::Kind::tension) {
      add_tension(r, each, size, forces);
    } else {
      add_warp(r, each.to, size, forces);
    }
  }
}

/// Equal shares of the force, and forces phi x (r_i - middle) for the moment that the hands' own
/// moments leave: the least forces that do it, orthogonal to internal ones.
Vector split_over_many(const std::vector<Digits50Vector3>& r, const Vector& wanted) {
  const auto n = static_cast<Eigen::Index>(r.size());
  Digits50Vector3 middle = Digits50Vector3::Zero();
  for (const Digits50Vector3& point : r) {
    middle += point / Digits50(n);
  }
  const Digits50Vector3 F = wanted.segment<3>(0);
  Digits50Vector3 M = wanted.segment<3>(3) - cross(middle, F);
  Digits50Matrix3 spread = Digits50Matrix3::Zero();
  Vector forces = Vector::Zero(6 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Digits50Vector3 arm = r[static_cast<std::size_t>(i)] - middle;
    spread += Digits50(arm.dot(arm)) * Digits50Matrix3::Identity() - arm * arm.transpose();
    forces.segment<3>(6 * i + 3) = wanted.segment<3>(6 + 3 * (n - 2) + 3 * i);
    M -= forces.segment<3>(6 * i + 3);
  }
  const Digits50Vector3 phi = spread.fullPivLu().solve(M);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Digits50Vector3 arm = r[static_cast<std::size_t>(i)] - middle;
    forces.segment<3>(6 * i) = F / Digits50(n) + cross(phi, arm);
  }
  add_linkage_forces(r, wanted, forces);
  return forces;
}

void snap(VirtualLinkage::Matrix& A) {
  const Digits50 scale = A.size() == 0 ? Digits50(1) : Digits50(A.cwiseAbs().maxCoeff());
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    for (Eigen::Index j = 0; j < A.cols(); ++j) {
      A(i, j) = snapped(A(i, j), scale);
    }
  }
}

}  // namespace

std::vector<LinkageForce> list_linkage_forces(const std::vector<Digits50Vector3>& points) {
  using enum LinkageForce::Kind;
  std::vector<LinkageForce> forces{{tension, 0, 1}, {tension, 1, 2}, {tension, 2, 0}};
  for (std::size_t k = 3; k < points.size(); ++k) {
    if (is_in_plane(points, k)) {
      append_in_plane(points, k, forces);
      continue;
    }
    for (std::size_t base = 0; base < 3; ++base) forces.push_back({tension, base, k});
  }
  return forces;
}

VirtualLinkage virtual_linkage(const std::vector<Digits50Vector3>& points) {
  const auto n = static_cast<Eigen::Index>(points.size());
  VirtualLinkage linkage{VirtualLinkage::Matrix(6 * n, 6 * n), {}};
  for (Eigen::Index j = 0; j < 6 * n; ++j) {
    const Vector one = Vector::Unit(6 * n, j);
    linkage.split.col(j) = n == 1   ? split_over_one(points, one)
                           : n == 2 ? split_over_two(points, one)
                                    : split_over_many(points, one);
  }
  linkage.read = linkage.split.fullPivLu().inverse().bottomRows(6 * (n - 1));
  snap(linkage.split);
  snap(linkage.read);
  return linkage;
}

}  // namespace treeline
