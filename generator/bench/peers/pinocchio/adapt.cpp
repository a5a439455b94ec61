#include "bench/peers/pinocchio/adapt.hpp"

#include <algorithm>

namespace treeline::peer::pin {
namespace {

Point frame_of(const peer::Point& point) {
  Point described{point.link, {}, {}};
  std::copy_n(point.R, 9, described.R.begin());
  std::copy_n(point.p, 3, described.p.begin());
  return described;
}

/// Describes a point. Returns false if it has other rows or axes than the routes support.
bool describe(const peer::Point& point, std::vector<Point>& points) {
  if (!point.world_axes) return false;
  if (std::find(std::begin(point.rows), std::end(point.rows), false) != std::end(point.rows)) {
    return false;
  }
  points.push_back(frame_of(point));
  return true;
}

Held describe(const peer::Constraint& constraint, const Tell& tell) {
  Held described{frame_of(constraint.frame), std::nullopt, holds_turns(constraint, tell)};
  if (constraint.other.link != nullptr) described.second = frame_of(constraint.other);
  return described;
}

/// Copies a column-major matrix in Pinocchio's order of joints to row-major in ours.
void reorder(const Solver<double>& s, const Eigen::MatrixXd& from, double* to) {
  const Eigen::Index n = s.model.nv;
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = 0; k < n; ++k) {
      to[i * n + k] =
          from(s.place[static_cast<std::size_t>(i)], s.place[static_cast<std::size_t>(k)]);
    }
  }
}

Eigen::MatrixXd whole(const double* upper, Eigen::Index n) {
  return Eigen::Map<const Eigen::MatrixXd>(upper, n, n).selfadjointView<Eigen::Upper>();
}

}  // namespace

Description describe(const Robot& robot, const Tell& tell) {
  const auto& g = robot.gravity;
  Description description{robot.urdf,
                          robot.floating,
                          {robot.links, robot.links + robot.velocities},
                          {g[0], g[1], g[2]},
                          {}};
  for (int i = 0; i < robot.point_count; ++i) {
    if (describe(robot.points[i], description.points)) continue;
    tell("is asked for points whose rows are all controlled, in the world's axes, only");
    description.points.clear();
    break;
  }
  for (int i = 0; i < robot.constraint_count; ++i) {
    description.held.push_back(describe(robot.constraints[i], tell));
  }
  return description;
}

void finish_symmetric(void* solver, double* out) {
  const auto& s = *static_cast<const Solver<double>*>(solver);
  reorder(s, whole(out, s.model.nv), out);
}

void finish_lambda(void* solver, double* out) {
  const auto& s = *static_cast<const Solver<double>*>(solver);
  const Eigen::MatrixXd all = whole(out, s.rows());
  Eigen::Map<Rows>(out, s.rows(), s.rows()) = all;
}

void finish_derivatives(void* solver, double* out) {
  const auto& s = *static_cast<const Solver<double>*>(solver);
  const Eigen::Index n = s.model.nv;
  for (const Eigen::Index matrix : {0, 1}) {
    double* at = out + matrix * n * n;
    reorder(s, Eigen::MatrixXd(Eigen::Map<const Eigen::MatrixXd>(at, n, n)), at);
  }
  finish_symmetric(solver, out + 2 * n * n);
}

}  // namespace treeline::peer::pin
