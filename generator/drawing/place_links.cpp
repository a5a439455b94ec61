#include "drawing/place_links.hpp"

#include <algorithm>

#include "interpreter/instances.hpp"
#include "mechanism/build_mechanism.hpp"
#include "mechanism/home_of.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline {
namespace {

using Vector = interpreter::Vector<double>;

Vector as_vector(std::span<const double> q) {
  return Vector::Map(q.data(), static_cast<Eigen::Index>(q.size()));
}

Eigen::Isometry3d as_isometry(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& position) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation;
  pose.translation() = position;
  return pose;
}

}  // namespace

LinkPlacer::LinkPlacer(const Robot& robot, const Scene& scene)
    : model_(model_from_robot<double>(robot, scene)),
      points_(points_from_scene(model_, scene.operational_points)) {
  for (const Coordinate& coordinate : build_mechanism(robot, scene).coordinates) {
    home_.push_back(home_of(coordinate));
    joints_.push_back(coordinate.joint);
  }
  for (const Link& link : robot.links) {
    for (int i = 0; i < model_.size(); ++i) {
      if (model_.body(i).name == link.name) bodies_.push_back(i);
    }
  }
}

std::vector<Eigen::Isometry3d> LinkPlacer::place(std::span<const double> q) const {
  const auto k = interpreter::kinematics<double>(model_, as_vector(q), Vector::Zero(model_.nv));
  std::vector<Eigen::Isometry3d> poses;
  for (const int body : bodies_) {
    poses.push_back(as_isometry(k.R_world[body], k.p_world[body]));
  }
  return poses;
}

std::vector<Eigen::Isometry3d> LinkPlacer::place_points(std::span<const double> q) const {
  std::vector<Eigen::Isometry3d> poses;
  for (const auto& at : interpreter::forward_kinematics<double>(model_, points_, as_vector(q))) {
    poses.push_back(as_isometry(at.rotation, at.position));
  }
  return poses;
}

}  // namespace treeline
