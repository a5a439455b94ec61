#include "bench/peers/pinocchio/read_solver.hpp"

#include <pinocchio/parsers/urdf.hpp>

namespace treeline::peer::pin {
namespace {

using pinocchio::Model;

Model read_model(const Description& description) {
  Model model;
  if (description.floating) {
    pinocchio::urdf::buildModel(description.urdf, pinocchio::JointModelFreeFlyer(), model);
  } else {
    pinocchio::urdf::buildModel(description.urdf, model);
  }
  model.gravity.linear() = Eigen::Map<const Eigen::Vector3d>(description.gravity.data());
  return model;
}

pinocchio::FrameIndex add_point(const Point& point, Model& model) {
  const auto link = model.frames[model.getBodyId(point.link)];
  return model.addFrame(pinocchio::Frame("point_" + point.link, link.parentJoint,
                                         model.getBodyId(point.link),
                                         link.placement * pose_of(point), pinocchio::OP_FRAME));
}

/// Returns the place of each of our velocities among Pinocchio's. Those of one joint are
/// consecutive.
std::vector<Eigen::Index> find_places(const Description& description, const Model& model) {
  std::vector<Eigen::Index> places;
  Eigen::Index within = 0;
  for (std::size_t i = 0; i < description.links.size(); ++i) {
    const bool same = i > 0 && description.links[i] == description.links[i - 1];
    within = same ? within + 1 : 0;
    const auto joint = model.frames[model.getBodyId(description.links[i])].parentJoint;
    places.push_back(model.joints[joint].idx_v() + within);
  }
  return places;
}

}  // namespace

std::optional<Solver<double>> read_solver(const Description& description) {
  Model model = read_model(description);
  const bool same_size = model.nv == static_cast<int>(description.links.size()) &&
                         model.nq == model.nv + (description.floating ? 1 : 0);
  if (!same_size) return std::nullopt;
  std::vector<pinocchio::FrameIndex> points;
  for (const Point& point : description.points) points.push_back(add_point(point, model));
  return Solver<double>(model, points, find_places(description, model), description.floating);
}

}  // namespace treeline::peer::pin
