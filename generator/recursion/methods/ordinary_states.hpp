#pragma once

#include <cstddef>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "recursion/methods/object_forward_dynamics.hpp"
#include "recursion/methods/task_law.hpp"
#include "recursion/tree/deferred_rotations.hpp"
#include "recursion/tree/model_inputs.hpp"

namespace treeline {

/// Ordinary states at which pivots are looked at. An odd number has a median.
inline constexpr int kOrdinaryStates = 15;

/// Coordinates spread evenly over the limits, of angles over a turn at most. What floats keeps its
/// axes: its rows can be moved in any.
std::vector<double> ordinary_state(const Mechanism& mechanism, int state);

/// A mechanism at a state, its points those of a law.
template <class Scalar>
struct Posed {
  Tree<Scalar> tree;
  std::vector<TreeObject<Scalar>> objects;
  std::vector<JointTransform<Scalar>> X;
};

/// The mechanism as it is in no pose yet, for `pose` at several states: rounding its constants
/// takes longer than a pose.
template <class Scalar>
Posed<Scalar> unposed(const Mechanism& mechanism, LawPoints points, const GivenTools& tools = {}) {
  Posed<Scalar> unposed;
  ModelInputs<Scalar> inputs;
  inputs.tools = triples(std::vector<Scalar>(tools.origins.begin(), tools.origins.end()));
  inputs.orientations =
      rotations(std::vector<Scalar>(tools.orientations.begin(), tools.orientations.end()));
  unposed.tree = tree_of<Scalar>(mechanism, inputs);
  if (points == LawPoints::contacts) unposed.tree.operational_points = unposed.tree.contacts;
  if (points == LawPoints::grasps) {
    unposed.objects = objects_of<Scalar>(mechanism);
    unposed.tree = holding_tree(unposed.tree, unposed.objects);
  }
  return unposed;
}

template <class Scalar>
Posed<Scalar> pose(Posed<Scalar> posed, LawPoints points, const std::vector<double>& q) {
  const std::vector<Scalar> at(q.begin(), q.end());
  posed.X = joint_transforms<Scalar>(posed.tree, at);
  defer_rotations(posed.tree, posed.X);
  if (points == LawPoints::grasps) follow_points(posed.tree, posed.objects);
  return posed;
}

template <class Scalar>
Posed<Scalar> pose(const Mechanism& mechanism, LawPoints points, const std::vector<double>& q,
                   const GivenTools& tools = {}) {
  return pose(unposed<Scalar>(mechanism, points, tools), points, q);
}

/// A row whose pivot is but rounding error of its diagonal depends on those before it.
constexpr double kDependent = 1e-10;

std::size_t count_rows(const Tree<double>& tree);

/// The middle one of those that are finite; 0 if there are none.
double median(std::vector<double> values);

/// A power of two: short in the code, and the same on every host.
double rounded_border(double border);
double rounded_border(double ordinary, const BoundedInverseShape& shape);

/// Remainders of the rows of a symmetric matrix A when LDL^T eliminates the rows before them, state
/// after state: their pivots, beside their diagonal entries.
class OrdinaryPivots {
 public:
  void add(const DenseMatrix<double>& A);
  /// Adds a state. If A is a difference, `diagonal` is that of the minuend, which sets its
  /// rounding.
  void add(const DenseMatrix<double>& A, const std::vector<double>& diagonal);

  [[nodiscard]] std::size_t rows() const { return pivots_.size(); }
  [[nodiscard]] double diagonal(std::size_t row) const { return median(diagonals_[row]); }
  /// Whether the row depends on rows before it in ordinary states.
  [[nodiscard]] bool is_dependent(std::size_t row) const;
  [[nodiscard]] bool has_dependent() const;
  /// For each row the share of the median of its pivots; of its diagonal entries if it depends on
  /// rows before it.
  [[nodiscard]] std::vector<double> borders(const BoundedInverseShape& shape) const;

 private:
  std::vector<std::vector<double>> pivots_, diagonals_;
};

/// For each row whether nothing that comes before can ever hold it: rows of the first point that
/// each floating joint carries.
std::vector<bool> always_free(const Tree<double>& tree);

}  // namespace treeline
