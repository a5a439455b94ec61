#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "interpreter/dual.hpp"
#include "interpreter/jacobian.hpp"
#include "interpreter/point_accelerations.hpp"

namespace treeline::interpreter {

/// A ball around a frame's origin, or a disc with an axis in that frame, that rolls without
/// slipping on the plane z = 0 of another frame, or on a ball around that frame's origin. A
/// negative `on_radius` is that of a bowl.
template <class Scalar>
struct Rolling {
  Scalar radius{};
  std::optional<Vector3<Scalar>> axis;  ///< of unit length
  std::optional<Scalar> on_radius;
};

/// Two frames on bodies, or on the world, whose rows are held relative to each other. Rows are x y
/// z of the first origin, and small turns of the first frame, seen from the second frame; it says
/// which of them are held. Where it rolls, x y z are velocities of the material points in contact.
template <class Scalar>
struct Loop {
  OperationalPoint<Scalar> first, second;
  std::optional<Rolling<Scalar>> rolling = {};
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

/// Constraints between parts of a robot. Its rows are those of the frames in turn, then one for
/// each coupling.
template <class Scalar>
struct Loops {
  std::vector<Loop<Scalar>> frames;
  std::vector<Coupling<Scalar>> couplings;
  [[nodiscard]] bool empty() const { return frames.empty() && couplings.empty(); }
};

template <class To, class From>
Loop<To> cast(const Loop<From>& loop) {
  const auto both = cast<To>(Points<From>{loop.first, loop.second});
  Loop<To> result{both[0], both[1]};
  if (!loop.rolling) return result;
  result.rolling = Rolling<To>{To(loop.rolling->radius), {}, {}};
  if (loop.rolling->axis) {
    result.rolling->axis = loop.rolling->axis->unaryExpr([](const From& x) { return To(x); });
  }
  if (loop.rolling->on_radius) result.rolling->on_radius = To(*loop.rolling->on_radius);
  return result;
}

template <class To, class From>
Loops<To> cast(const Loops<From>& loops) {
  Loops<To> result;
  for (const auto& loop : loops.frames) result.frames.push_back(cast<To>(loop));
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

/// From the first origin to where the first body touches, in the world: along a disc's line of
/// steepest descent as far as the plane, or toward the other centre, whose distance is taken as the
/// sum of the radii.
template <class Scalar>
Vector3<Scalar> to_contact(const Rolling<Scalar>& rolling, const LoopState<Scalar>& at) {
  const Scalar R = rolling.radius;
  if (rolling.on_radius) return -R / Scalar(R + *rolling.on_radius) * at.d;
  const Vector3<Scalar> normal = at.R.col(2);
  if (!rolling.axis) return -R * normal;
  const Vector3<Scalar> axis = at.R_first * *rolling.axis;
  const Vector3<Scalar> up = normal - normal.dot(axis) * axis;
  return -normal.dot(at.d) / Scalar(up.squaredNorm()) * up;
}

/// How far a contact is from touching: (s^2 - d^2) / 2d along the normal, which is s - d to first
/// order; s: distance or height at hand, d: as it is to be. Of a disc, whose height is to be that
/// sine of its lean times the radius R, (s^2 - d^2) / 2R. Seen from the second frame.
template <class Scalar>
Vector3<Scalar> contact_gap(const Rolling<Scalar>& rolling, const LoopState<Scalar>& at) {
  const Vector3<Scalar> d = at.R.transpose() * at.d;
  const Scalar R = rolling.radius;
  if (rolling.on_radius) {
    const Scalar wanted = R + *rolling.on_radius;
    return (d.squaredNorm() / Scalar(wanted * wanted) - Scalar(1)) / Scalar(2) * d;
  }
  Vector3<Scalar> gap = Vector3<Scalar>::Zero();
  gap(2) = d(2) - R;
  if (rolling.axis) {
    const Scalar lean = at.R.col(2).dot(Vector3<Scalar>(at.R_first * *rolling.axis));
    gap(2) = (d(2) * d(2) - R * R * (Scalar(1) - lean * lean)) / Scalar(Scalar(2) * R);
  }
  return gap;
}

/// A frame with world axes on a body, at a point of the world.
template <class Scalar>
OperationalPoint<Scalar> material_point(const OperationalPoint<Scalar>& on,
                                        const Vector3<Scalar>& at, const Kinematics<Scalar>& k) {
  OperationalPoint<Scalar> point = on;
  point.p = k.R_world[on.body].transpose() * Vector3<Scalar>(at - k.p_world[on.body]);
  return point;
}

/// J of the six rows of a loop.
template <class Scalar>
Matrix<Scalar> six_rows(const Model<Scalar>& model, const Loop<Scalar>& loop,
                        const Kinematics<Scalar>& k) {
  const LoopState<Scalar> at(loop, k);
  auto both = in_world(loop);
  Vector3<Scalar> apart = at.d;  // of the points whose velocities are compared
  if (loop.rolling) {
    const Vector3<Scalar> touching = k.p_world[loop.first.body] +
                                     k.R_world[loop.first.body] * loop.first.p +
                                     to_contact(*loop.rolling, at);
    for (auto& point : both) point = material_point(point, touching, k);
    apart.setZero();
  }
  const int carrier = nearest_common(model, loop.first.body, loop.second.body);
  const Matrix<Scalar> first = rows_from(model, both[0], carrier, k);
  const Matrix<Scalar> second = rows_from(model, both[1], carrier, k);
  Matrix<Scalar> all(6, model.nv);
  all.topRows(3) = at.R.transpose() * (first.topRows(3) - second.topRows(3) +
                                       cross_matrix(apart) * second.bottomRows(3));
  all.bottomRows(3) = at.R.transpose() * (first.bottomRows(3) - second.bottomRows(3));
  return all;
}

/// Jd qd of the six rows of a loop that rolls: the derivative of J qd along the motion, by dual
/// numbers.
template <class Scalar>
Matrix<Scalar> rolling_bias(const Model<Scalar>& model, const Loop<Scalar>& loop,
                            const Vector<Scalar>& q, const Vector<Scalar>& qd) {
  using Number = Dual<Scalar>;
  const Vector<Scalar> rate = position_derivative<Scalar>(model, q, qd);
  Vector<Number> moving(q.size());
  for (Eigen::Index i = 0; i < q.size(); ++i) moving(i) = Number(q(i), rate(i));
  const auto in_dual = cast<Number>(model);
  const auto k = kinematics<Number>(in_dual, moving, Vector<Number>::Zero(qd.size()));
  const Matrix<Number> J = six_rows<Number>(in_dual, cast<Number>(loop), k);
  Matrix<Scalar> bias = Matrix<Scalar>::Zero(6, 1);
  for (Eigen::Index i = 0; i < 6; ++i) {
    for (Eigen::Index v = 0; v < qd.size(); ++v) bias(i, 0) += J(i, v).slope * qd(v);
  }
  return bias;
}

/// Jd qd of the six rows of a loop of two frames.
template <class Scalar>
Matrix<Scalar> frame_bias(const Model<Scalar>& model, const Loop<Scalar>& loop,
                          const Kinematics<Scalar>& k, const Vector<Scalar>& q,
                          const Vector<Scalar>& qd) {
  const LoopState<Scalar> at(loop, k);
  const auto both = in_world(loop);
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
  return stack<Scalar>(Vector3<Scalar>(at.R.transpose() * linear),
                       Vector3<Scalar>(at.R.transpose() * angular));
}

/// Selects the rows that the loop holds from all six rows.
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
    const Matrix<Scalar> held = detail::held_of(loop, detail::six_rows(model, loop, k));
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
    const Matrix<Scalar> held =
        detail::held_of(loop, loop.rolling ? detail::rolling_bias<Scalar>(model, loop, q, qd)
                                           : detail::frame_bias<Scalar>(model, loop, k, q, qd));
    bias.segment(row, held.rows()) = held.col(0);
    row += held.rows();
  }
  return bias;
}

/// How far all rows are from being closed: m, and the sine of a turn about the row's axis. Where a
/// loop rolls, the gap along the normal; its other rows hold velocities alone.
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
    Matrix<Scalar> all =
        stack<Scalar>(Vector3<Scalar>(at.R.transpose() * at.d), Vector3<Scalar>(twist / Scalar(2)));
    if (loop.rolling) {
      all = stack<Scalar>(detail::contact_gap(*loop.rolling, at), Vector3<Scalar>::Zero());
    }
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
