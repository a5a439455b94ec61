#pragma once

#include "recursion/algebra/dense_matrix.hpp"
#include "recursion/methods/task_basis.hpp"

namespace treeline {

/// Adds to `J` the columns of joint `link` for one task point. The rows' directions and the
/// reference point relative to the link's origin are given in the link's axes. An entry is the work
/// of the row's unit wrench on the joint: e.(z x r) = r.x e.y - r.y e.x for a rotation about z.
template <class Scalar>
void add_joint_columns(const TreeLink<Scalar>& link, const TaskPoint<Scalar>& task,
                       std::size_t first_row, DenseMatrix<Scalar>& J) {
  const auto at = static_cast<std::size_t>(link.v_index);
  for (std::size_t k = 0; k < task.rows.size(); ++k) {
    const TaskRow<Scalar>& row = task.rows[k];
    const std::size_t i = first_row + k;
    if (link.is_floating()) {
      const Wrench<Scalar> wrench = unit_wrench(task, row);
      const Scalar parts[6] = {wrench.f.x, wrench.f.y, wrench.f.z,
                               wrench.n.x, wrench.n.y, wrench.n.z};
      for (std::size_t c = 0; c < 6; ++c) {
        J(i, at + c) = parts[c];
      }
    } else if (link.is_angular(0)) {
      const Scalar rate = row.angular ? row.e.z : task.r.x * row.e.y - task.r.y * row.e.x;
      J(i, at) = J(i, at) + link.multiplier * rate;
    } else {
      J(i, at) = J(i, at) + (row.angular ? Scalar(0.0) : link.multiplier * row.e.z);
    }
  }
}

/// Row `axis` of a matrix.
template <class Scalar>
const Vector3<Scalar>& row_of(const Matrix3<Scalar>& A, int axis) {
  return axis == 0 ? A.row_x : axis == 1 ? A.row_y : A.row_z;
}

/// Puts the task's rows of the Jacobian of the centre of mass into J.
template <class Scalar>
void set_center_rows(const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
                     const TaskPoint<Scalar>& task, std::size_t first_row, DenseMatrix<Scalar>& J) {
  const auto whole = center_of_mass_jacobian(tree, X);
  for (std::size_t k = 0; k < task.rows.size(); ++k) {
    for (std::size_t v = 0; v < J.cols(); ++v) {
      J(first_row + k, v) = whole(static_cast<std::size_t>(task.rows[k].axis), v);
    }
  }
}

/// J by carrying each point's rows inward from its link, which is cheap if the task's axes are the
/// link's. Rows along the axes from which `poses` are seen are taken from `poses` instead.
template <class Scalar>
DenseMatrix<Scalar> jacobian_inward(const Tree<Scalar>& tree,
                                    const std::vector<JointTransform<Scalar>>& X,
                                    std::vector<TaskPoint<Scalar>> tasks, std::size_t rows,
                                    const std::vector<WorldPose<Scalar>>& poses) {
  DenseMatrix<Scalar> J(rows, static_cast<std::size_t>(tree.nv));
  std::size_t first_row = 0;
  for (TaskPoint<Scalar>& task : tasks) {
    const std::size_t count = task.rows.size();
    if (!task.parts.empty()) set_center_rows(tree, X, task, first_row, J);
    while (task.link >= 0) {
      const auto i = static_cast<std::size_t>(task.link);
      section(tree.links[i], i, "Jacobian");
      add_joint_columns(tree.links[i], task, first_row, J);
      task.r = X[i].to_parent(task.r) + X[i].p;
      const int h = tree.links[i].parent;
      for (TaskRow<Scalar>& row : task.rows) {
        row.e = task.along_poses && h >= 0 ? row_of(poses[static_cast<std::size_t>(h)].R, row.axis)
                                           : X[i].to_parent(row.e);
      }
      task.link = h;
    }
    first_row += count;
  }
  return J;
}

/// Velocity of a point at `arm` from the joint per unit of the joint's velocity, for one degree of
/// freedom: linear over angular, world axes.
template <class Scalar>
Wrench<Scalar> unit_velocity(const JointStep& joint, const Vector3<Scalar>& z,
                             const Vector3<Scalar>& arm) {
  return joint.is_angular(0) ? Wrench<Scalar>{cross(z, arm), z} : Wrench<Scalar>{z, {}};
}

/// J in the axes from which `poses` are seen, from the poses of all links: z x (p_point - p_joint).
/// Points share the rotations; cheap for links near those axes. Differences of positions are summed
/// from the steps between joints, because subtracting positions would lose digits if the robot is
/// far from the world's origin.
template <class Scalar>
DenseMatrix<Scalar> jacobian_world(const Tree<Scalar>& tree,
                                   const std::vector<WorldPose<Scalar>>& poses, TaskBasis basis,
                                   std::size_t rows) {
  DenseMatrix<Scalar> J(rows, static_cast<std::size_t>(tree.nv));
  std::size_t first_row = 0;
  for (const TreePoint<Scalar>& point : tree.operational_points) {
    const TaskPoint<Scalar> task = task_point(point, basis, poses);
    Vector3<Scalar> arm;
    if (!basis.at_link_origin) {
      arm = point_pose(poses, point).step;
    }
    for (int i = point.link; i >= 0; i = tree.links[static_cast<std::size_t>(i)].parent) {
      const auto at = static_cast<std::size_t>(i);
      const TreeLink<Scalar>& link = tree.links[at];
      const Matrix3<Scalar>& R = poses[at].R;
      section(link, at, "Jacobian");
      if (link.is_floating()) {
        TaskPoint<Scalar> seen{i, transposed_times(R, arm), task.rows};
        const Vector3<Scalar> axes[3] = {R.row_x, R.row_y, R.row_z};
        std::size_t k = 0;
        for (std::size_t row = 0; row < 6; ++row) {
          if (point.rows[row]) {
            seen.rows[k++].e = axes[row % 3];
          }
        }
        add_joint_columns(link, seen, first_row, J);
        arm = arm + poses[at].step;
        continue;
      }
      const Wrench<Scalar> v = unit_velocity(link, {R.row_x.z, R.row_y.z, R.row_z.z}, arm);
      arm = arm + poses[at].step;
      const Scalar column[6] = {v.f.x, v.f.y, v.f.z, v.n.x, v.n.y, v.n.z};
      std::size_t k = first_row;
      for (std::size_t row = 0; row < 6; ++row) {
        if (point.rows[row]) {
          Scalar& entry = J(k++, static_cast<std::size_t>(link.v_index));
          entry = entry + link.multiplier * column[row];
        }
      }
    }
    first_row += task.rows.size();
  }
  return J;
}

}  // namespace treeline
