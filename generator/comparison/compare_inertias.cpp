#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "comparison/difference.hpp"
#include "description/robot_queries.hpp"
#include "description/rotation.hpp"

namespace treeline {
namespace {

Eigen::Matrix3d inertia_in_link_axes(const Inertial& inertial) {
  Eigen::Matrix3d J;
  J << inertial.ixx, inertial.ixy, inertial.ixz,  //
      inertial.ixy, inertial.iyy, inertial.iyz,   //
      inertial.ixz, inertial.iyz, inertial.izz;
  const Eigen::Matrix3d R = rotation_from_rpy<double>(inertial.origin.rpy);
  return R * J * R.transpose();
}

double relative(double difference, double a, double b) {
  const double larger = std::max(std::abs(a), std::abs(b));
  return larger > 0 ? difference / larger : 0;
}

/// Distance of the centres of mass, m. 0 if one link has no mass and so no centre.
double distance_of_centres(const Inertial& a, const Inertial& b) {
  if (a.mass == 0 || b.mass == 0) return 0;
  const Eigen::Vector3d centre_a = Eigen::Map<const Eigen::Vector3d>(a.origin.xyz.data());
  const Eigen::Vector3d centre_b = Eigen::Map<const Eigen::Vector3d>(b.origin.xyz.data());
  return (centre_a - centre_b).norm();
}

}  // namespace

void compare_inertias(const Robot& first, const Robot& second, const RobotMatch& match,
                      RobotDifference& difference) {
  difference.first_mass = total_mass(first);
  difference.second_mass = total_mass(second);
  for (std::size_t i = 0; i < match.links.size(); ++i) {
    const Link& link_a = first.links[static_cast<std::size_t>(match.links[i].first)];
    const Link& link_b = second.links[static_cast<std::size_t>(match.links[i].second)];
    const Inertial a = link_a.inertial.value_or(Inertial{});
    const Inertial b = link_b.inertial.value_or(Inertial{});
    const Eigen::Matrix3d J_a = inertia_in_link_axes(a), J_b = inertia_in_link_axes(b);
    LinkDifference& link = difference.links[i];
    link.first_mass = a.mass;
    link.second_mass = b.mass;
    link.mass = relative(std::abs(a.mass - b.mass), a.mass, b.mass);
    link.centre = distance_of_centres(a, b);
    link.inertia = relative((J_a - J_b).norm(), J_a.norm(), J_b.norm());
  }
}

}  // namespace treeline
