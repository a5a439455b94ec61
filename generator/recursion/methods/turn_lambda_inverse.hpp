#pragma once

#include <vector>

#include "recursion/algebra/dense_matrix.hpp"
#include "recursion/methods/task_basis.hpp"

namespace treeline {

template <class Scalar>
Matrix3<Scalar> block3(const DenseMatrix<Scalar>& A, std::size_t row, std::size_t col) {
  return {{A(row, col), A(row, col + 1), A(row, col + 2)},
          {A(row + 1, col), A(row + 1, col + 1), A(row + 1, col + 2)},
          {A(row + 2, col), A(row + 2, col + 1), A(row + 2, col + 2)}};
}

template <class Scalar>
void set_block3(DenseMatrix<Scalar>& A, std::size_t row, std::size_t col,
                const Matrix3<Scalar>& block) {
  const Vector3<Scalar> rows[3] = {block.row_x, block.row_y, block.row_z};
  for (std::size_t i = 0; i < 3; ++i) {
    const Scalar entries[3] = {rows[i].x, rows[i].y, rows[i].z};
    for (std::size_t j = 0; j < 3; ++j) {
      A(row + i, col + j) = A(col + j, row + i) = entries[j];
    }
  }
}

/// Rotates the vectors that the rows and columns of a symmetric matrix consist of, three by three.
/// `turn` maps Symmetric3 and Matrix3 to R A R^T.
template <class Scalar, class Turn>
void turn_triples(DenseMatrix<Scalar>& A, Turn turn) {
  for (std::size_t i = 0; i < A.rows(); i += 3) {
    for (std::size_t j = 0; j < i; j += 3) {
      set_block3(A, i, j, turn(block3(A, i, j)));
    }
    const Matrix3<Scalar> own = block3(A, i, i);
    const Symmetric3<Scalar> turned = turn(Symmetric3<Scalar>{
        own.row_x.x, own.row_x.y, own.row_x.z, own.row_y.y, own.row_y.z, own.row_z.z});
    set_block3(A, i, i,
               {{turned.xx, turned.xy, turned.xz},
                {turned.xy, turned.yy, turned.yz},
                {turned.xz, turned.yz, turned.zz}});
  }
}

/// R^T A R for the axes of a point on a link.
template <class Scalar>
Symmetric3<Scalar> to_point_axes(const Matrix3<Scalar>& R, const Symmetric3<Scalar>& A) {
  return congruent(transposed(R), A);
}
template <class Scalar>
Matrix3<Scalar> to_point_axes(const Matrix3<Scalar>& R, const Matrix3<Scalar>& A) {
  return transposed(R) * (A * R);
}

/// Whether `turn_to_asked_axes` can rotate from the axes of link `from` to those of the scene: to
/// the world's through the joints below, or outward to those of a single point, through joints of
/// one degree of freedom. Rows must form whole triples.
template <class Scalar>
bool permits_turning(const Tree<Scalar>& tree, int from) {
  const auto& points = tree.operational_points;
  const bool world = points.front().axes == Axes::world;
  for (const TreePoint<Scalar>& point : points) {
    const bool alike = (point.axes == Axes::world) == world &&
                       (world || (point.link == points.front().link && points.size() == 1));
    if (!alike || !has_whole_triples(point) || point.link < 0) {
      return false;
    }
  }
  const int last = world ? -1 : from;
  int at = world ? from : points.front().link;
  for (; at > last; at = tree.links[static_cast<std::size_t>(at)].parent) {
    if (tree.links[static_cast<std::size_t>(at)].is_floating()) {
      return false;
    }
  }
  return at == last;
}

/// Rotates Lambda^-1 from the axes of link `from` to those of the scene, block by block, about one
/// joint axis after the other: 16 operations per symmetric block and 23 per other block.
template <class Scalar>
void turn_to_asked_axes(const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
                        int from, DenseMatrix<Scalar>& Lambda_inv) {
  const TreePoint<Scalar>& point = tree.operational_points.front();
  if (point.axes == Axes::world) {
    for (int at = from; at >= 0; at = tree.links[static_cast<std::size_t>(at)].parent) {
      const auto i = static_cast<std::size_t>(at);
      section(tree.links[i], i, "turn");
      turn_triples(Lambda_inv, [&](const auto& A) { return X[i].matrix_to_parent(A); });
    }
    return;
  }
  std::vector<std::size_t> path;
  for (int at = point.link; at != from; at = tree.links[static_cast<std::size_t>(at)].parent) {
    path.push_back(static_cast<std::size_t>(at));
  }
  for (auto i = path.rbegin(); i != path.rend(); ++i) {
    section(tree.links[*i], *i, "turn");
    turn_triples(Lambda_inv, [&](const auto& A) { return X[*i].matrix_to_child(A); });
  }
  turn_triples(Lambda_inv, [&](const auto& A) { return to_point_axes(point.R, A); });
}

}  // namespace treeline
