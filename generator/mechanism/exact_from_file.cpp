#include "mechanism/exact_from_file.hpp"

#include "description/rotation.hpp"

namespace treeline {

ExactPose exact_pose(const Pose& pose) {
  ExactPose result;
  result.R = rotation_from_rpy<Exact>(pose.rpy);
  for (int i = 0; i < 3; ++i) {
    result.p(i) = pose.xyz[static_cast<std::size_t>(i)];
  }
  return result;
}

Inertia exact_inertia(const Inertial& body) {
  ExactMatrix3 J;
  J << body.ixx, body.ixy, body.ixz, body.ixy, body.iyy, body.iyz, body.ixz, body.iyz, body.izz;
  Inertia about_center;
  about_center.mass = body.mass;
  about_center.Sigma = J.trace() / 2 * ExactMatrix3::Identity() - J;
  return transformed(about_center, exact_pose(body.origin));
}

Exact radius_of_gyration(const Inertia& inertia) {
  const Exact square = inertia.mass > 0 ? Exact(inertia.Sigma.trace() / inertia.mass) : Exact(0);
  return square > 0 ? Exact(sqrt(square)) : Exact(0);
}

ExactMatrix3 rotation_from_z_to(const ExactVector3& axis) {
  const Exact square = axis(0) * axis(0) + axis(1) * axis(1);
  if (square == 0 && axis(2) < 0) {
    ExactMatrix3 half_turn = ExactMatrix3::Identity();
    half_turn(1, 1) = half_turn(2, 2) = -1;
    return half_turn;
  }
  // Near -z the sum 1 + z would cancel.
  const Exact one_plus_z = axis(2) < 0 ? Exact(square / (1 - axis(2))) : Exact(1 + axis(2));
  // Rodrigues' formula about z x axis = (-axis_y, axis_x, 0).
  ExactMatrix3 K = ExactMatrix3::Zero();
  K(0, 2) = axis(0);
  K(1, 2) = axis(1);
  K(2, 0) = -axis(0);
  K(2, 1) = -axis(1);
  return ExactMatrix3::Identity() + K + K * K / one_plus_z;
}

ExactMatrix3 rotation_z_by(const Exact& angle) {
  const double from_file = static_cast<double>(angle);
  if (Exact(from_file) != angle) {
    return rotation_z(angle);
  }
  return rotation_from_rpy<Exact>({0, 0, from_file});
}

}  // namespace treeline
