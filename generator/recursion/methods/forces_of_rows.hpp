#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "recursion/methods/inverse_dynamics.hpp"
#include "recursion/methods/task_basis.hpp"

namespace treeline {

/// Adds forces f in the rows of `tasks` to the wrenches on the links.
template <class Scalar>
void add_row_forces(const std::vector<TaskPoint<Scalar>>& tasks, const std::vector<Scalar>& f,
                    std::vector<Wrench<Scalar>>& wrenches) {
  std::size_t row = 0;
  for (const TaskPoint<Scalar>& task : tasks) {
    Wrench<Scalar> at_point;
    for (const TaskRow<Scalar>& direction : task.rows) {
      Vector3<Scalar>& sum = direction.angular ? at_point.n : at_point.f;
      sum = sum + direction.e * f[row++];
    }
    for (const TaskPart<Scalar>& part : task.parts) {
      Vector3<Scalar> force;
      for (std::size_t k = 0; k < task.rows.size(); ++k) {
        force = force + part.directions[k] * f[row - task.rows.size() + k];
      }
      wrenches[part.link] = wrenches[part.link] + wrench_on_part(part, force);
    }
    if (task.link < 0) continue;
    Wrench<Scalar>& wrench = wrenches[static_cast<std::size_t>(task.link)];
    wrench = wrench + wrench_at(at_point.f, at_point.n, task.r);
  }
}

/// Joint forces J^T f due to forces f in the rows of `tasks`.
template <class Scalar>
std::vector<Scalar> forces_of_rows(const Tree<Scalar>& tree,
                                   const std::vector<JointTransform<Scalar>>& X,
                                   const std::vector<TaskPoint<Scalar>>& tasks,
                                   const std::vector<Scalar>& f) {
  std::vector<Wrench<Scalar>> wrenches(tree.links.size());
  add_row_forces(tasks, f, wrenches);
  return inward_forces(tree, X, std::move(wrenches));
}

}  // namespace treeline
