#pragma once

#include <utility>
#include <vector>

#include "interpreter/jacobian.hpp"
#include "interpreter/point_accelerations.hpp"

namespace treeline::interpreter {

/// Two frames on bodies, or on the world, whose rows are held relative to each other. Rows are x y
/// z of the first origin, and small turns of the first frame, seen from the second frame; it says
/// which of them are held.
template <class Scalar>
struct Loop {
  OperationalPoint<Scalar> first, second;
};

/// A linear relation between joints: the sum of factor times coordinate, plus the offset, is 0.
template <class Scalar>
struct Coupling {
  struct Part {
    int q = 0, v = 0;
    Scalar factor{};
  };
  std::vector<Part> parts;
  Scalar offset{};
};

/// What holds parts of a robot to each other. Its rows: those of the frames in turn, then one for
/// each coupling.
template <class Scalar>
struct Loops {
  std::vector<Loop<Scalar>> frames;
  std::vector<Coupling<Scalar>> couplings;
  [[nodiscard]] bool empty() const { return frames.empty() && couplings.empty(); }
};

template <class To, class From>
Loops<To> cast(const Loops<From>& loops) {
  Loops<To> result;
  for (const auto& [first, second] : loops.frames) {
    const auto both = cast<To>(Points<From>{first, second});
    result.frames.push_back({both[0], both[1]});
  }
  for (const auto& coupling : loops.couplings) {
    result.couplings.push_back({{}, To(coupling.offset)});
    for (const auto& [q, v, factor] : coupling.parts) {
      result.couplings.back().parts.push_back({q, v, To(factor)});
    }
  }
  return result;
}

template <class Scalar>
int row_count(const Loops<Scalar>& loops) {
  int count = static_cast<int>(loops.couplings.size());
  for (const auto& loop : loops.frames) count += row_count<Scalar>({loop.second});
  return count;
}

namespace detail {

/// Both frames of a loop with all rows and world axes.
template <class Scalar>
Points<Scalar> in_world(const Loop<Scalar>& loop) {
  Points<Scalar> both{loop.first, loop.second};
  for (auto& point : both) {
    point.axes = PointAxes::world;
    point.rows = {true, true, true, true, true, true};
  }
  return both;
}

/// A loop at a state, in world axes.
template <class Scalar>
struct LoopState {
  LoopState(const Loop<Scalar>& loop, const Kinematics<Scalar>& k)
      : R_first(k.R_world[loop.first.body] * loop.first.R),
        R(k.R_world[loop.second.body] * loop.second.R),
        d(k.p_world[loop.first.body] + k.R_world[loop.first.body] * loop.first.p -
          k.p_world[loop.second.body] - k.R_world[loop.second.body] * loop.second.p) {}

  Matrix3<Scalar> R_first, R;  ///< axes of the frames
  Vector3<Scalar> d;           ///< from the second origin to the first
};

/// The nearest body, or the world, that carries both.
template <class Scalar>
int nearest_common(const Model<Scalar>& model, int first, int second) {
  const auto carries = [&](int body, int carried) {
    while (carried != body && carried != kWorld) carried = model.body(carried).parent;
    return carried == body;
  };
  while (!carries(first, second)) first = model.body(first).parent;
  return first;
}

/// Six rows of a point by the joints between it and a body that carries it: for that body at rest.
template <class Scalar>
Matrix<Scalar> rows_from(const Model<Scalar>& model, const OperationalPoint<Scalar>& point,
                         int carrier, const Kinematics<Scalar>& k) {
  Matrix<Scalar> J = Matrix<Scalar>::Zero(6, model.nv);
  Matrix6<Scalar> to_point = point_transform(point, k).transpose();
  for (int i = point.body; i != carrier; i = model.body(i).parent) {
    const Body<Scalar>& body = model.body(i);
    J.middleCols(body.v, k.S[i].cols()) += body.multiplier * (to_point * k.S[i]);
    to_point = (to_point * k.X[i].transpose()).eval();
  }
  return J;
}

/// Of six rows those that the loop holds.
template <class Scalar>
Matrix<Scalar> held_of(const Loop<Scalar>& loop, const Matrix<Scalar>& all) {
  return all(controlled_rows<Scalar>({loop.second}), Eigen::all);
}

}  // namespace detail

/// J of all rows, from x = R^T (p_1 - p_2) and its rate R^T (v_1 - v_2 - w_2 x (p_1 - p_2)), R:
/// axes of the second frame in the world. Joints that carry both frames play no part.
template <class Scalar>
Matrix<Scalar> loop_jacobian(const Model<Scalar>& model, const Loops<Scalar>& loops,
                             VectorArg<Scalar> q) {
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  Matrix<Scalar> J = Matrix<Scalar>::Zero(row_count(loops), model.nv);
  Eigen::Index row = 0;
  for (const auto& loop : loops.frames) {
    const detail::LoopState<Scalar> at(loop, k);
    const auto both = detail::in_world(loop);
    const int carrier = detail::nearest_common(model, loop.first.body, loop.second.body);
    const Matrix<Scalar> first = detail::rows_from(model, both[0], carrier, k);
    const Matrix<Scalar> second = detail::rows_from(model, both[1], carrier, k);
    Matrix<Scalar> all(6, model.nv);
    all.topRows(3) = at.R.transpose() * (first.topRows(3) - second.topRows(3) +
                                         cross_matrix(at.d) * second.bottomRows(3));
    all.bottomRows(3) = at.R.transpose() * (first.bottomRows(3) - second.bottomRows(3));
    const Matrix<Scalar> held = detail::held_of(loop, all);
    J.middleRows(row, held.rows()) = held;
    row += held.rows();
  }
  for (const auto& coupling : loops.couplings) {
    for (const auto& part : coupling.parts) J(row, part.v) += part.factor;
    ++row;
  }
  return J;
}

/// Jd qd of all rows: second derivatives of x at qdd = 0.
template <class Scalar>
Vector<Scalar> loop_bias(const Model<Scalar>& model, const Loops<Scalar>& loops,
                         VectorArg<Scalar> q, VectorArg<Scalar> qd) {
  const auto k = kinematics<Scalar>(model, q, qd);
  Vector<Scalar> bias = Vector<Scalar>::Zero(row_count(loops));
  Eigen::Index row = 0;
  for (const auto& loop : loops.frames) {
    const detail::LoopState<Scalar> at(loop, k);
    const auto both = detail::in_world(loop);
    const Vector<Scalar> v = jacobian<Scalar>(model, both, q) * qd;
    const Vector<Scalar> a = bias_acceleration<Scalar>(model, both, q, qd);
    const Vector3<Scalar> w_1 = v.template segment<3>(3);
    const Vector3<Scalar> w_2 = v.template segment<3>(9);
    const Vector3<Scalar> wd_2 = a.template segment<3>(9);
    const Vector3<Scalar> rate = v.template segment<3>(0) - v.template segment<3>(6);
    const Vector3<Scalar> linear = a.template segment<3>(0) - a.template segment<3>(6) -
                                   cross(wd_2, at.d) - Scalar(2) * cross(w_2, rate) +
                                   cross(w_2, cross(w_2, at.d));
    const Vector3<Scalar> angular = a.template segment<3>(3) - wd_2 - cross(w_2, w_1);
    const Matrix<Scalar> all = stack<Scalar>(Vector3<Scalar>(at.R.transpose() * linear),
                                             Vector3<Scalar>(at.R.transpose() * angular));
    const Matrix<Scalar> held = detail::held_of(loop, all);
    bias.segment(row, held.rows()) = held.col(0);
    row += held.rows();
  }
  return bias;
}

/// How far all rows are from being closed: m, and the sine of a turn about the row's axis.
template <class Scalar>
Vector<Scalar> loop_errors(const Model<Scalar>& model, const Loops<Scalar>& loops,
                           VectorArg<Scalar> q) {
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  Vector<Scalar> errors(row_count(loops));
  Eigen::Index row = 0;
  for (const auto& loop : loops.frames) {
    const detail::LoopState<Scalar> at(loop, k);
    const Matrix3<Scalar> turn = at.R.transpose() * at.R_first;
    const Vector3<Scalar> twist{turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0),
                                turn(1, 0) - turn(0, 1)};
    const Matrix<Scalar> all =
        stack<Scalar>(Vector3<Scalar>(at.R.transpose() * at.d), Vector3<Scalar>(twist / Scalar(2)));
    const Matrix<Scalar> held = detail::held_of(loop, all);
    errors.segment(row, held.rows()) = held.col(0);
    row += held.rows();
  }
  for (const auto& coupling : loops.couplings) {
    errors(row) = coupling.offset;
    for (const auto& part : coupling.parts) errors(row) += part.factor * q(part.q);
    ++row;
  }
  return errors;
}

}  // namespace treeline::interpreter
