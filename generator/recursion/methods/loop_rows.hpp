#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "recursion/methods/jacobian.hpp"
#include "recursion/tree/rolling_lever.hpp"

// Constraints between two links, and between joints, as rows of velocities that are zero. A loop
// depends on the joints between its links alone: those that carry both are as good as at rest.

namespace treeline {

/// Rows at a state.
template <class Scalar>
struct LoopRows {
  DenseMatrix<Scalar> J;       ///< rows x nv
  std::vector<Scalar> bias;    ///< Jd qd
  std::vector<Scalar> errors;  ///< how far they are from closed: m, sines of turns, or a coupling's
};

/// Three axes.
template <class Scalar>
using Triple = std::array<Vector3<Scalar>, 3>;

template <class Scalar>
Triple<Scalar> axes_of(const Matrix3<Scalar>& R) {
  const Matrix3<Scalar> columns = transposed(R);
  return {columns.row_x, columns.row_y, columns.row_z};
}

/// Links from `link` inward that do not carry `other` as well.
template <class Scalar>
std::vector<std::size_t> links_apart(const Tree<Scalar>& tree, int link, int other) {
  std::vector<bool> carries_other(tree.links.size());
  for (int i = other; i >= 0; i = tree.links[static_cast<std::size_t>(i)].parent) {
    carries_other[static_cast<std::size_t>(i)] = true;
  }
  std::vector<std::size_t> links;
  while (link >= 0 && !carries_other[static_cast<std::size_t>(link)]) {
    links.push_back(static_cast<std::size_t>(link));
    link = tree.links[static_cast<std::size_t>(link)].parent;
  }
  return links;
}

/// One loop: what its rows measure, seen from the links on both sides.
template <class Scalar>
class LoopSides {
 public:
  LoopSides(const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
            const TreeLoop<Scalar>& loop)
      : tree_(tree),
        X_(X),
        loop_(loop),
        near_(links_apart(tree, loop.first.link, loop.second.link)),
        far_(links_apart(tree, loop.second.link, loop.first.link)),
        seen_(tree.links.size()) {
    Seen at{loop.first.p, {}};
    for (const std::size_t i : near_) {
      seen_[i].p = at.p;
      at.p = X[i].to_parent(at.p) + X[i].p;
    }
    at.e = axes_of(loop.second.R);
    for (const std::size_t i : far_) {
      seen_[i].e = at.e;
      for (Vector3<Scalar>& e : at.e) e = X[i].to_parent(e);
    }
    between_ = at;
    for (auto i = near_.rbegin(); i != near_.rend(); ++i) {
      for (Vector3<Scalar>& e : at.e) e = X[*i].to_child(e);
      seen_[*i].e = at.e;
    }
    at.p = between_.p;
    for (auto i = far_.rbegin(); i != far_.rend(); ++i) {
      at.p = X[*i].to_child(at.p - X[*i].p);
      seen_[*i].p = at.p;
    }
  }

  /// J of the six rows x y z rx ry rz of the first frame.
  [[nodiscard]] DenseMatrix<Scalar> jacobian() const {
    DenseMatrix<Scalar> J(6, static_cast<std::size_t>(tree_.nv));
    for (const std::size_t i : near_) add_columns(i, Scalar(1.0), J);
    for (const std::size_t i : far_) add_columns(i, Scalar(-1.0), J);
    return J;
  }

  /// J of the six rows that are held, from that of the first frame: where the loop rolls, its
  /// linear rows are those of the point that is in contact.
  [[nodiscard]] DenseMatrix<Scalar> at_contact(DenseMatrix<Scalar> J) const {
    if (!loop_.rolling) return J;
    const Vector3<Scalar> r = lever({}, {}).r;
    for (std::size_t v = 0; v < J.cols(); ++v) {
      const Vector3<Scalar> moved = cross({J(3, v), J(4, v), J(5, v)}, r);
      J(0, v) = J(0, v) + moved.x;
      J(1, v) = J(1, v) + moved.y;
      J(2, v) = J(2, v) + moved.z;
    }
    return J;
  }

  /// Jd qd of the six rows that are held; `u`: velocities of those of the first frame. With the
  /// second frame as origin, points of the first one have Coriolis accelerations.
  [[nodiscard]] std::array<Scalar, 6> bias(std::span<const Scalar> qd,
                                           const std::vector<Scalar>& u) const {
    const LinkMotion<Scalar> first = motion(near_, qd);
    const LinkMotion<Scalar> second = motion(far_, qd);
    const Seen& at_first = seen_at(near_);
    const Seen& at_second = seen_at(far_);
    const Vector3<Scalar> w = along(at_second.e, second.w);
    const Vector3<Scalar> turning{u[3], u[4], u[5]};
    Vector3<Scalar> linear = along(at_first.e, acceleration_at(first, at_first.p)) -
                             along(at_second.e, acceleration_at(second, at_second.p)) -
                             cross(w, {u[0], u[1], u[2]}) * Scalar(2.0);
    const Vector3<Scalar> angular =
        along(at_first.e, first.wd) - along(at_second.e, second.wd) - cross(w, turning);
    if (loop_.rolling) {
      const RollingLever<Scalar> contact = lever({u[0], u[1], u[2]}, turning);
      linear = linear + cross(angular, contact.r) + cross(turning, contact.rate);
    }
    return {linear.x, linear.y, linear.z, angular.x, angular.y, angular.z};
  }

  /// How far the first frame is from the second.
  [[nodiscard]] std::array<Scalar, 6> errors() const {
    if (loop_.rolling) {
      const Vector3<Scalar> error = lever({}, {}).error;
      return {error.x, error.y, error.z, Scalar(0.0), Scalar(0.0), Scalar(0.0)};
    }
    const Seen& at_first = seen_at(near_);
    const Vector3<Scalar> d = displacement();
    const Triple<Scalar> f = axes_of(loop_.first.R);
    const Triple<Scalar>& e = at_first.e;
    const auto sine = [&](std::size_t i, std::size_t j) {
      return Scalar(0.5) * (dot(e[j], f[i]) - dot(e[i], f[j]));
    };
    return {d.x, d.y, d.z, sine(1, 2), sine(2, 0), sine(0, 1)};
  }

 private:
  /// The origin of the first frame and the axes of the second, in some link's frame.
  struct Seen {
    Vector3<Scalar> p;
    Triple<Scalar> e;
  };

  /// From the outermost of these links; from what carries both sides if there are none.
  [[nodiscard]] const Seen& seen_at(const std::vector<std::size_t>& inward) const {
    return inward.empty() ? between_ : seen_[inward.front()];
  }

  static Vector3<Scalar> along(const Triple<Scalar>& e, const Vector3<Scalar>& v) {
    return {dot(e[0], v), dot(e[1], v), dot(e[2], v)};
  }

  /// Displacement of the first origin from the second one, along the axes of the second frame.
  [[nodiscard]] Vector3<Scalar> displacement() const {
    const Seen& at_second = seen_at(far_);
    return along(at_second.e, at_second.p - loop_.second.p);
  }

  /// Lever of a loop that rolls, at these velocities of the first frame.
  [[nodiscard]] RollingLever<Scalar> lever(const Vector3<Scalar>& v,
                                           const Vector3<Scalar>& w) const {
    Vector3<Scalar> axis;
    if (loop_.rolling->axis) {
      axis = along(seen_at(near_).e, loop_.first.R * *loop_.rolling->axis);
    }
    return rolling_lever(*loop_.rolling, displacement(), axis, v, w);
  }

  void add_columns(std::size_t i, const Scalar& sign, DenseMatrix<Scalar>& J) const {
    const TreeLink<Scalar>& link = tree_.links[i];
    section(link, i, "Jacobian of a loop");
    TaskPoint<Scalar> task{static_cast<int>(i), seen_[i].p, {}};
    for (std::size_t row = 0; row < 6; ++row) {
      task.rows.push_back({row >= 3, seen_[i].e[row % 3] * sign, static_cast<int>(row % 3)});
    }
    add_joint_columns(link, task, 0, J);
  }

  /// Motion of the outermost of these links with what carries both sides at rest, at qdd = 0.
  LinkMotion<Scalar> motion(const std::vector<std::size_t>& inward,
                            std::span<const Scalar> qd) const {
    LinkMotion<Scalar> motion;
    for (auto i = inward.rbegin(); i != inward.rend(); ++i) {
      section(tree_.links[*i], *i, "motion in a loop");
      motion = motion_behind_joint(tree_.links[*i], X_[*i], motion, JointRates<Scalar>{qd, {}});
      motion.U = angular_matrix(motion.w, motion.wd);
    }
    return motion;
  }

  const Tree<Scalar>& tree_;
  const std::vector<JointTransform<Scalar>>& X_;
  const TreeLoop<Scalar>& loop_;
  std::vector<std::size_t> near_, far_;  ///< links on the first and on the second side, inward
  Seen between_;                         ///< from the link, or the world, that carries both sides
  std::vector<Seen> seen_;               ///< from each link on either side
};

template <class Scalar>
std::size_t count_loop_rows(const Tree<Scalar>& tree) {
  std::size_t rows = tree.couplings.size();
  for (const TreeLoop<Scalar>& loop : tree.loops) {
    const auto& on = loop.second.rows;
    rows += static_cast<std::size_t>(std::count(on.begin(), on.end(), true));
  }
  return rows;
}

template <class Scalar>
bool has_loops(const Tree<Scalar>& tree) {
  return !tree.loops.empty() || !tree.couplings.empty();
}

template <class Scalar>
std::vector<LoopSides<Scalar>> loop_sides(const Tree<Scalar>& tree,
                                          const std::vector<JointTransform<Scalar>>& X) {
  std::vector<LoopSides<Scalar>> sides;
  for (const TreeLoop<Scalar>& loop : tree.loops) sides.emplace_back(tree, X, loop);
  return sides;
}

/// Copies row `i` of a matrix to row `j` of another of the same width.
template <class Scalar>
void copy_row(const DenseMatrix<Scalar>& from, std::size_t i, DenseMatrix<Scalar>& to,
              std::size_t j) {
  for (std::size_t v = 0; v < from.cols(); ++v) to(j, v) = from(i, v);
}

/// J of the rows, from the six rows of each loop.
template <class Scalar>
DenseMatrix<Scalar> held_rows_of(const Tree<Scalar>& tree,
                                 const std::vector<DenseMatrix<Scalar>>& loops) {
  DenseMatrix<Scalar> J(count_loop_rows(tree), static_cast<std::size_t>(tree.nv));
  std::size_t at = 0;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    for (std::size_t row = 0; row < 6; ++row) {
      if (tree.loops[k].second.rows[row]) copy_row(loops[k], row, J, at++);
    }
  }
  for (const MechanismCoupling& coupling : tree.couplings) {
    for (const auto& part : coupling.parts) {
      Scalar& entry = J(at, static_cast<std::size_t>(part.v_index));
      entry = entry + Scalar(part.factor);
    }
    ++at;
  }
  return J;
}

/// J of the rows alone.
template <class Scalar>
DenseMatrix<Scalar> loop_jacobian(const Tree<Scalar>& tree,
                                  const std::vector<JointTransform<Scalar>>& X) {
  std::vector<DenseMatrix<Scalar>> loops;
  for (const LoopSides<Scalar>& sides : loop_sides(tree, X)) {
    loops.push_back(sides.at_contact(sides.jacobian()));
  }
  return held_rows_of(tree, loops);
}

/// J qd.
template <class Scalar>
std::vector<Scalar> velocities_of(const DenseMatrix<Scalar>& J, std::span<const Scalar> qd) {
  std::vector<Scalar> velocities(J.rows(), Scalar(0.0));
  for (std::size_t i = 0; i < J.rows(); ++i) {
    for (std::size_t v = 0; v < J.cols(); ++v) velocities[i] = velocities[i] + J(i, v) * qd[v];
  }
  return velocities;
}

/// All rows at a state. `q` is read for the errors of couplings alone; empty: these are left out.
template <class Scalar>
LoopRows<Scalar> loop_rows(const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
                           std::span<const Scalar> q, std::span<const Scalar> qd) {
  const auto sides = loop_sides(tree, X);
  std::vector<DenseMatrix<Scalar>> loops;
  std::vector<std::vector<Scalar>> velocities;
  for (const LoopSides<Scalar>& each : sides) {
    auto J = each.jacobian();
    velocities.push_back(velocities_of(J, qd));
    loops.push_back(each.at_contact(std::move(J)));
  }
  LoopRows<Scalar> rows;
  rows.J = held_rows_of(tree, loops);
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const auto bias = sides[k].bias(qd, velocities[k]);
    const auto errors = sides[k].errors();
    for (std::size_t row = 0; row < 6; ++row) {
      if (!tree.loops[k].second.rows[row]) continue;
      rows.bias.push_back(bias[row]);
      rows.errors.push_back(errors[row]);
    }
  }
  for (const MechanismCoupling& coupling : tree.couplings) {
    Scalar error(coupling.offset);
    for (std::size_t i = 0; i < coupling.parts.size() && !q.empty(); ++i) {
      const auto& part = coupling.parts[i];
      error = error + Scalar(part.factor) * q[static_cast<std::size_t>(part.q_index)];
    }
    rows.bias.emplace_back(0.0);
    rows.errors.push_back(error);
  }
  return rows;
}

/// J of the rows of all points and loops: the first `anchored` rows of the points, which are held
/// to the world, then those of `loops`, then the other points'.
template <class Scalar>
DenseMatrix<Scalar> jacobian_with_loops(const Tree<Scalar>& tree,
                                        const std::vector<JointTransform<Scalar>>& X,
                                        const std::vector<TaskPoint<Scalar>>& tasks,
                                        std::size_t anchored, const DenseMatrix<Scalar>& loops) {
  std::size_t rows = 0;
  for (const TaskPoint<Scalar>& task : tasks) rows += task.rows.size();
  const auto points = jacobian_inward(tree, X, tasks, rows, world_poses(tree, X));
  DenseMatrix<Scalar> J(rows + loops.rows(), static_cast<std::size_t>(tree.nv));
  for (std::size_t i = 0; i < loops.rows(); ++i) copy_row(loops, i, J, anchored + i);
  for (std::size_t i = 0; i < rows; ++i) {
    copy_row(points, i, J, i < anchored ? i : i + loops.rows());
  }
  return J;
}

}  // namespace treeline
