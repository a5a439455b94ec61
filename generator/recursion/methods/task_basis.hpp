#pragma once

#include <algorithm>
#include <vector>

#include "recursion/methods/center_of_mass.hpp"
#include "recursion/methods/inverse_dynamics.hpp"
#include "recursion/methods/link_velocities.hpp"

namespace treeline {

/// Coordinates in which the rows of operational points are computed.
struct TaskBasis {
  bool in_link_axes = false;    ///< link's axes instead of those of the scene
  bool at_link_origin = false;  ///< link's origin instead of the point
  int axes_link = -1;           ///< axes of this link for all points; -1: not used
};

/// One row of a task. The unit force (or moment) e at `r` does work at the rate of the row's
/// velocity. Everything is in the axes of the point's link.
template <class Scalar>
struct TaskRow {
  bool angular = false;
  Vector3<Scalar> e;
  int axis = 0;  ///< index of x y z of the task's axes
};

/// A link's part in a task of the centre of mass: how far the rows, along `directions` in the
/// link's axes, are moved by the link.
template <class Scalar>
struct TaskPart {
  std::size_t link = 0;
  MassShare<Scalar> share;
  std::vector<Vector3<Scalar>> directions;
};

/// Rows of one operational point, in the order of the scene. Those of the centre of mass are as if
/// on the world, and on links by parts.
template <class Scalar>
struct TaskPoint {
  int link = -1;
  Vector3<Scalar> r;  ///< reference point of linear rows, in the link's axes
  std::vector<TaskRow<Scalar>> rows;
  bool along_poses = false;  ///< the rows' axes are those from which the poses are seen
  std::vector<TaskPart<Scalar>> parts = {};
};

/// Whether a point is the centre of mass.
template <class Scalar>
bool has_center_of_mass(const Tree<Scalar>& tree) {
  return std::any_of(tree.operational_points.begin(), tree.operational_points.end(),
                     [](const TreePoint<Scalar>& point) { return point.center_of_mass; });
}

template <class Scalar>
bool has_whole_triples(const TreePoint<Scalar>& point) {
  const auto& on = point.rows;
  return on[0] == on[1] && on[1] == on[2] && on[3] == on[4] && on[4] == on[5];
}
template <class Scalar>
bool has_all_rows(const TreePoint<Scalar>& point) {
  return has_whole_triples(point) && point.rows[0] && point.rows[3];
}

/// Whether the tree permits this basis. Axes other than the scene's need whole triples of rows (all
/// of x y z or none) of points on links, the link's origin needs all six rows.
template <class Scalar>
bool permits(const Tree<Scalar>& tree, TaskBasis basis) {
  return std::all_of(tree.operational_points.begin(), tree.operational_points.end(),
                     [basis](const TreePoint<Scalar>& point) {
                       const bool asked = !basis.in_link_axes && basis.axes_link < 0;
                       const bool turns = has_whole_triples(point) && !point.center_of_mass;
                       return (asked || turns) && (!basis.at_link_origin || has_all_rows(point));
                     });
}

/// R_task_link, whose rows are the task's axes in the link's coordinates. `poses` are seen from
/// `basis.axes_link`.
template <class Scalar>
Matrix3<Scalar> task_from_link(const TreePoint<Scalar>& point, TaskBasis basis,
                               const std::vector<WorldPose<Scalar>>& poses) {
  if (basis.in_link_axes) {
    return identity3<Scalar>();
  }
  if (point.axes == Axes::world || basis.axes_link >= 0) {
    return point.link < 0 ? identity3<Scalar>() : poses[static_cast<std::size_t>(point.link)].R;
  }
  return transposed(point.R);
}

template <class Scalar>
TaskPoint<Scalar> task_point(const TreePoint<Scalar>& point, TaskBasis basis,
                             const std::vector<WorldPose<Scalar>>& poses) {
  const Matrix3<Scalar> E = task_from_link(point, basis, poses);
  const Vector3<Scalar> unit[3] = {E.row_x, E.row_y, E.row_z};
  TaskPoint<Scalar> task{point.link, basis.at_link_origin ? Vector3<Scalar>{} : point.p, {}};
  task.along_poses = basis.axes_link >= 0 || (point.axes == Axes::world && !basis.in_link_axes);
  for (std::size_t k = 0; k < 6; ++k) {
    if (point.rows[k]) {
      task.rows.push_back({k >= 3, unit[k % 3], static_cast<int>(k % 3)});
    }
  }
  return task;
}

/// The parts of links with mass in a task of the centre of mass.
template <class Scalar>
std::vector<TaskPart<Scalar>> task_parts(const Tree<Scalar>& tree, const TaskPoint<Scalar>& task,
                                         const std::vector<WorldPose<Scalar>>& poses) {
  const auto shares = link_shares(tree);
  std::vector<TaskPart<Scalar>> parts;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const auto& [mass, h] = shares[i];
    const Scalar zero(0.0);
    if (mass == zero && h.x == zero && h.y == zero && h.z == zero) continue;
    const Vector3<Scalar> world[3] = {poses[i].R.row_x, poses[i].R.row_y, poses[i].R.row_z};
    parts.push_back({i, shares[i], {}});
    for (const TaskRow<Scalar>& row : task.rows) parts.back().directions.push_back(world[row.axis]);
  }
  return parts;
}

template <class Scalar>
std::vector<TaskPoint<Scalar>> task_points(const Tree<Scalar>& tree, TaskBasis basis,
                                           const std::vector<WorldPose<Scalar>>& poses) {
  std::vector<TaskPoint<Scalar>> tasks;
  for (const TreePoint<Scalar>& point : tree.operational_points) {
    tasks.push_back(task_point(point, basis, poses));
    if (point.center_of_mass) tasks.back().parts = task_parts(tree, tasks.back(), poses);
  }
  return tasks;
}

/// Wrench of a unit force along the row.
template <class Scalar>
Wrench<Scalar> unit_wrench(const TaskPoint<Scalar>& task, const TaskRow<Scalar>& row) {
  return row.angular ? Wrench<Scalar>{{}, row.e} : wrench_at(row.e, Vector3<Scalar>{}, task.r);
}

/// Wrench on a link of a force on the centre of mass, which is along `f` in the link's axes: it
/// spreads over the links as the mass does.
template <class Scalar>
Wrench<Scalar> wrench_on_part(const TaskPart<Scalar>& part, const Vector3<Scalar>& f) {
  return {f * part.share.mass, cross(part.share.h, f)};
}

/// Whether linear rows of the point are along axes that turn with its link.
template <class Scalar>
bool has_turning_rows(const TreePoint<Scalar>& point) {
  return point.axes == Axes::local && point.link >= 0 &&
         (point.rows[0] || point.rows[1] || point.rows[2]);
}

/// The motion of a link as its own axes count it, which turn: the rate of a point's velocity is
/// less by w x (v + w x r) there, so that a - w x v + wd x r is left (spatial acceleration, RBDA
/// sect. 2.10).
template <class Scalar>
LinkMotion<Scalar> counted_in_turning_axes(LinkMotion<Scalar> motion, const Vector3<Scalar>& v) {
  motion.a = motion.a - cross(motion.w, v);
  motion.U = angular_matrix(Vector3<Scalar>{}, motion.wd);
  return motion;
}

/// The motion of the centre of mass as that of a frame at rest on the world but for it.
template <class Scalar>
LinkMotion<Scalar> motion_of_center(const Tree<Scalar>& tree,
                                    const std::vector<JointTransform<Scalar>>& X,
                                    const std::vector<LinkMotion<Scalar>>& motions,
                                    const Vector3<Scalar>& base_acceleration) {
  LinkMotion<Scalar> motion;
  motion.a = center_of_mass_acceleration(tree, X, motions);
  if (!tree.has_world_matter) return motion;
  Scalar at_rest(1.0);
  for (const auto& share : link_shares(tree)) at_rest = at_rest - share.mass;
  motion.a = motion.a + base_acceleration * at_rest;
  return motion;
}

/// The motion of each point's link, from which `acceleration_at` gives the rates of the velocities
/// of its rows: J qdd + Jd qd. `base_acceleration` is that of `motions`.
template <class Scalar>
std::vector<LinkMotion<Scalar>> motions_of_rows(const Tree<Scalar>& tree,
                                                const std::vector<JointTransform<Scalar>>& X,
                                                const std::vector<LinkMotion<Scalar>>& motions,
                                                std::span<const Scalar> qd,
                                                const Vector3<Scalar>& base_acceleration) {
  const auto& points = tree.operational_points;
  std::vector<LinkVelocity<Scalar>> velocities;
  if (std::any_of(points.begin(), points.end(), has_turning_rows<Scalar>)) {
    velocities = link_velocities(tree, X, {qd, {}});
  }
  LinkMotion<Scalar> world;
  world.a = base_acceleration;
  std::vector<LinkMotion<Scalar>> of_rows;
  for (const TreePoint<Scalar>& point : points) {
    const auto link = static_cast<std::size_t>(point.link);
    of_rows.push_back(point.center_of_mass ? motion_of_center(tree, X, motions, base_acceleration)
                      : point.link < 0     ? world
                                           : motions[link]);
    if (has_turning_rows(point)) {
      of_rows.back() = counted_in_turning_axes(of_rows.back(), velocities[link].v);
    }
  }
  return of_rows;
}

/// Rates of the velocities of the rows of all points, J qdd + Jd qd, from `motions` of the links
/// without gravity.
template <class Scalar>
std::vector<Scalar> row_accelerations(const Tree<Scalar>& tree,
                                      const std::vector<JointTransform<Scalar>>& X,
                                      const std::vector<TaskPoint<Scalar>>& tasks,
                                      const std::vector<LinkMotion<Scalar>>& motions,
                                      std::span<const Scalar> qd) {
  const auto of_rows = motions_of_rows(tree, X, motions, qd, Vector3<Scalar>{});
  std::vector<Scalar> accelerations;
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    const Vector3<Scalar> linear = acceleration_at(of_rows[k], tasks[k].r);
    for (const TaskRow<Scalar>& row : tasks[k].rows) {
      accelerations.push_back(dot(row.e, row.angular ? of_rows[k].wd : linear));
    }
  }
  return accelerations;
}

/// Jd qd of all rows, by one outward pass with qdd = 0 and no gravity (Chang eq. 6.11, 6.12).
template <class Scalar>
std::vector<Scalar> bias_acceleration(const Tree<Scalar>& tree,
                                      const std::vector<JointTransform<Scalar>>& X,
                                      const std::vector<TaskPoint<Scalar>>& tasks,
                                      std::span<const Scalar> qd) {
  const auto motions = outward_motion(tree, X, {qd, {}}, Vector3<Scalar>{});
  return row_accelerations(tree, X, tasks, motions, qd);
}

}  // namespace treeline
