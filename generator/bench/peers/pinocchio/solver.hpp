#pragma once

#include <pinocchio/multibody.hpp>
#include <vector>

#include "bench/peers/pinocchio/description.hpp"

/// Pinocchio behind the plain calls of the benchmark. Templates on the scalar: `double` is timed,
/// CppADCodeGen's scalar is recorded. Each algorithm has its own source file, because it costs a
/// compiler half a minute and two gigabytes.
namespace treeline::peer::pin {

template <class Scalar>
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
template <class Scalar>
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// Pose of a frame in its link's.
inline pinocchio::SE3 pose_of(const Point& point) {
  using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  return {Eigen::Map<const Rows>(point.R.data()),
          Eigen::Map<const Eigen::Vector3d>(point.p.data())};
}

/// A model, and memory for everything that a call writes. No call allocates.
template <class Scalar>
struct Solver {
  using Model = pinocchio::ModelTpl<Scalar>;
  using Data = pinocchio::DataTpl<Scalar>;

  Model model;
  Data data;
  std::vector<pinocchio::FrameIndex> points;
  bool floating;
  std::vector<Eigen::Index> place;  ///< place of each of our velocities among Pinocchio's
  Vector<Scalar> q, qd, drive, xdd, torque;
  Matrix<Scalar> J, JT, scaled, lambda_inverse;

  Solver(const Model& with_points, std::vector<pinocchio::FrameIndex> frames,
         std::vector<Eigen::Index> places, bool on_floating_base)
      : model(with_points),
        data(model),
        points(std::move(frames)),
        floating(on_floating_base),
        place(std::move(places)),
        q(Vector<Scalar>::Zero(model.nq)),
        qd(Vector<Scalar>::Zero(model.nv)),
        drive(qd),
        xdd(Vector<Scalar>::Zero(rows())),
        torque(qd),
        J(Matrix<Scalar>::Zero(rows(), model.nv)),
        JT(J.transpose()),
        scaled(JT),
        lambda_inverse(Matrix<Scalar>::Zero(rows(), rows())) {}

  [[nodiscard]] Eigen::Index rows() const { return 6 * static_cast<Eigen::Index>(points.size()); }

  [[nodiscard]] std::size_t position_count() const { return static_cast<std::size_t>(model.nq); }

  void load_position(const Scalar* from) {
    const Eigen::Index extra = floating ? 1 : 0;
    if (floating) {
      for (Eigen::Index i = 0; i < 7; ++i) q(i) = from[i];
    }
    for (std::size_t i = floating ? 6 : 0; i < place.size(); ++i) {
      q(place[i] + extra) = from[static_cast<Eigen::Index>(i) + extra];
    }
  }
  void load(const Scalar* from, Vector<Scalar>& to) const {
    for (std::size_t i = 0; i < place.size(); ++i) to(place[i]) = from[i];
  }
  void store(const Vector<Scalar>& from, Scalar* to) const {
    for (std::size_t i = 0; i < place.size(); ++i) to[i] = from(place[i]);
  }
  void load_motion(const Scalar* const* in) {
    load_position(in[0]);
    load(in[1], qd);
    load(in[2], drive);
  }
};

}  // namespace treeline::peer::pin
