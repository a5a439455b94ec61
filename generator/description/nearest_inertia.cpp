#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>

#include "description/inertias.hpp"
#include "description/read_number.hpp"

namespace treeline {
namespace {

constexpr double kKept = 1e-9;    ///< of the largest entry
constexpr double kRaised = 1e-8;  ///< of the trace
constexpr double kRounding = 1e-15;
constexpr double kFlatMoment = 1e-7;  ///< of the largest eigenvalue: what figures in a file leave

Eigen::Matrix3d matrix_of(const Inertial& i) {
  Eigen::Matrix3d J;
  J << i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz;
  return J;
}

/// From inertia to second moments.
Eigen::Matrix3d second_moments(const Eigen::Matrix3d& J) {
  return J.trace() / 2 * Eigen::Matrix3d::Identity() - J;
}

double rounded(double value) {
  return read_number(fmt::format("{:.9g}", value)).value_or(value);
}

/// The inertia with entries of `J`, rounded; where next to nothing changes, as they were.
Inertial with_moments(const Inertial& old, const Eigen::Matrix3d& J, double scale) {
  Inertial result = old;
  const std::array<std::pair<double*, double>, 6> entries{{{&result.ixx, J(0, 0)},
                                                           {&result.ixy, J(0, 1)},
                                                           {&result.ixz, J(0, 2)},
                                                           {&result.iyy, J(1, 1)},
                                                           {&result.iyz, J(1, 2)},
                                                           {&result.izz, J(2, 2)}}};
  for (const auto& [entry, value] : entries) {
    if (std::abs(*entry - value) > kKept * scale) *entry = rounded(value);
  }
  return result;
}

/// Sigma with its eigenvalues raised to `least`, as an inertia.
Eigen::Matrix3d raised(const Eigen::Matrix3d& Sigma, double least) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(Sigma);
  const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(least);
  const Eigen::Matrix3d& axes = solver.eigenvectors();
  const Eigen::Matrix3d possible = axes * values.asDiagonal() * axes.transpose();
  return possible.trace() * Eigen::Matrix3d::Identity() - possible;
}

Eigen::Vector3d eigenvalues(const Eigen::Matrix3d& A) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace

std::optional<Inertial> nearest_possible_inertia(const Inertial& inertial) {
  const double scale = matrix_of(inertial).cwiseAbs().maxCoeff();
  Inertial with_mass = inertial;
  with_mass.mass = 1;  // whether there is mass is another matter
  if (!find_unphysical(with_mass)) return std::nullopt;
  // Scaled, so that nothing overflows or underflows.
  const Eigen::Matrix3d Sigma = second_moments(matrix_of(inertial) / scale);
  const Inertial nearest = with_moments(inertial, raised(Sigma, 0) * scale, scale);
  const double least = eigenvalues(second_moments(matrix_of(nearest) / scale))[0];
  if (least >= -kRounding) return nearest;
  const double floor = kRaised * eigenvalues(Sigma).cwiseMax(0).sum();
  return with_moments(inertial, raised(Sigma, floor) * scale, scale);
}

std::optional<std::string> name_of_flat_body(const Inertial& inertial) {
  if (!(inertial.mass > 0) || find_unphysical(inertial)) return std::nullopt;
  const double scale = matrix_of(inertial).cwiseAbs().maxCoeff();
  if (scale == 0) return "a point";
  const Eigen::Vector3d values = eigenvalues(second_moments(matrix_of(inertial) / scale));
  const double flat = kFlatMoment * values[2];
  if (values[1] <= flat) return "a rod";
  if (values[0] <= flat) return "a plate";
  return std::nullopt;
}

}  // namespace treeline
