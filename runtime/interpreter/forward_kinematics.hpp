#pragma once

#include "interpreter/center_of_mass.hpp"

namespace treeline::interpreter {

/// Pose of a point's frame: its origin in the world, and the rotation from its own axes to the
/// world's. The centre of mass has the world's axes.
template <class Scalar>
struct PointPose {
  Vector3<Scalar> position;
  Matrix3<Scalar> rotation;
};

template <class Scalar>
std::vector<PointPose<Scalar>> forward_kinematics(const Model<Scalar>& model,
                                                  PointsArg<Scalar> points, VectorArg<Scalar> q) {
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  std::vector<PointPose<Scalar>> poses;
  for (const auto& e : points) {
    if (e.center_of_mass) {
      poses.push_back({center_of_mass<Scalar>(model, q), Matrix3<Scalar>::Identity()});
      continue;
    }
    poses.push_back({k.p_world[e.body] + k.R_world[e.body] * e.p, k.R_world[e.body] * e.R});
  }
  return poses;
}

}  // namespace treeline::interpreter
