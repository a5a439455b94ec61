#pragma once

#include <Eigen/Geometry>
#include <ignition/math/Pose3.hh>
#include <optional>
#include <sdf/Link.hh>
#include <sdf/Model.hh>
#include <sdf/Root.hh>
#include <string>
#include <vector>

#include "description/flat/flat_model.hpp"
#include "description/sdf/read_sdf.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Links, frames and joints of a model and of those nested in it, whose names have `MODEL::` before
/// them. `file` is for the diagnostics. Nothing, and an error, where a pose or an axis cannot be
/// resolved or a joint is of a kind that has no place here.
std::optional<FlatModel> flatten_model(const sdf::Model& model, const std::string& file,
                                       Diagnostics& diagnostics);

/// libsdformat's reading of a text, with the places of `read_sdf`. Its errors
/// become errors in `diagnostics`, but what it says of inertias does not: that is for the readers
/// of URDF. Elements that SDF does not know are warnings.
std::optional<sdf::Root> load_sdf(const SdfText& text, Diagnostics& diagnostics);

/// Shapes of a link's `<visual>` and `<collision>` that URDF has, too: boxes, cylinders, spheres
/// and meshes, with diffuse colours. `model://` becomes `package://`. Others are left out: they are
/// for pictures alone.
std::vector<FlatShape> read_shapes(const sdf::Link& link);

/// A pose of libsdformat as a matrix and a place, quaternion and place as they are.
inline Eigen::Isometry3d to_isometry(const ignition::math::Pose3d& pose) {
  const auto& q = pose.Rot();
  Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
  isometry.linear() = Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).toRotationMatrix();
  isometry.translation() = Eigen::Vector3d(pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z());
  return isometry;
}

}  // namespace treeline
