#include "mechanism/digits50_from_file.hpp"

#include "description/rotation.hpp"

namespace treeline {

Digits50Pose digits50_pose(const Pose& pose) {
  Digits50Pose result;
  result.R = rotation_from_rpy<Digits50>(pose.rpy);
  for (int i = 0; i < 3; ++i) {
    result.p(i) = pose.xyz[static_cast<std::size_t>(i)];
  }
  return result;
}

Inertia digits50_inertia(const Inertial& body) {
  Digits50Matrix3 J;
  J << body.ixx, body.ixy, body.ixz, body.ixy, body.iyy, body.iyz, body.ixz, body.iyz, body.izz;
  Inertia about_center;
  about_center.mass = body.mass;
  about_center.Sigma = J.trace() / 2 * Digits50Matrix3::Identity() - J;
  return transformed(about_center, digits50_pose(body.origin));
}

Digits50 radius_of_gyration(const Inertia& inertia) {
  const Digits50 square =
      inertia.mass > 0 ? Digits50(inertia.Sigma.trace() / inertia.mass) : Digits50(0);
  return square > 0 ? Digits50(sqrt(square)) : Digits50(0);
}

Digits50Matrix3 rotation_from_z_to(const Digits50Vector3& axis) {
  const Digits50 square = axis(0) * axis(0) + axis(1) * axis(1);
  if (square == 0 && axis(2) < 0) {
    Digits50Matrix3 half_turn = Digits50Matrix3::Identity();
    half_turn(1, 1) = half_turn(2, 2) = -1;
    return half_turn;
  }
  // Near -z the sum 1 + z would cancel.
  const Digits50 one_plus_z =
      axis(2) < 0 ? Digits50(square / (1 - axis(2))) : Digits50(1 + axis(2));
  // Rodrigues' formula about z x axis = (-axis_y, axis_x, 0).
  Digits50Matrix3 K = Digits50Matrix3::Zero();
  K(0, 2) = axis(0);
  K(1, 2) = axis(1);
  K(2, 0) = -axis(0);
  K(2, 1) = -axis(1);
  return Digits50Matrix3::Identity() + K + K * K / one_plus_z;
}

Digits50Matrix3 rotation_z_by(const Digits50& angle) {
  const double from_file = static_cast<double>(angle);
  if (Digits50(from_file) != angle) {
    return rotation_z(angle);
  }
  return rotation_from_rpy<Digits50>({0, 0, from_file});
}

}  // namespace treeline
