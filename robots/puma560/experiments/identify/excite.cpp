#include "excite.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "puma560_identify.hpp"

namespace treeline::experiments {
namespace {

/// Limits of position as the URDF has them, rad.
const JointVector kLower{-2.79, -3.93, -0.79, -1.92, -1.75, -4.64};
const JointVector kUpper{2.79, 0.79, 3.93, 2.97, 1.75, 4.64};
/// What the motion may take of speeds and accelerations: rad/s, rad/s^2.
const JointVector kSpeed{2, 2, 2.5, 4, 4, 4};
const JointVector kAcceleration{6, 6, 8, 15, 15, 15};
constexpr int kLook = 100;  ///< moments of a period at which a candidate is judged

}  // namespace

double Noise::uniform() {  // splitmix64
  state_ += 0x9e3779b97f4a7c15;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
}

double Noise::normal() {  // Marsaglia's polar method
  double x = 0, square = 0;
  while (square == 0 || square >= 1) {
    x = uniform();
    const double y = uniform();
    square = x * x + y * y;
  }
  return x * std::sqrt(-2 * std::log(square) / square);
}

Excitation::Excitation(std::uint64_t seed)
    : middle_((kLower + kUpper) / 2), scale_(JointVector::Ones()) {
  Noise noise(seed);
  for (double& each : amplitudes_.reshaped()) each = noise.uniform();
  JointVector shift;
  for (double& each : shift) each = 0.3 * noise.uniform();
  JointVector q = JointVector::Zero(), qd = q, qdd = q;
  for (int k = 0; k < kLook; ++k) {
    const Moment moment = offset_at(kPeriod * k / kLook);
    q = q.cwiseMax(moment.q.cwiseAbs());
    qd = qd.cwiseMax(moment.qd.cwiseAbs());
    qdd = qdd.cwiseMax(moment.qdd.cwiseAbs());
  }
  const JointVector room = (kUpper - kLower) / 2;
  middle_ += room.cwiseProduct(shift);
  // A share is left for what lies between the moments that were looked at.
  const JointVector reach = 0.9 * room.cwiseProduct(JointVector::Ones() - shift.cwiseAbs());
  scale_ = reach.cwiseQuotient(q)
               .cwiseMin(kSpeed.cwiseQuotient(qd))
               .cwiseMin(kAcceleration.cwiseQuotient(qdd));
}

Excitation Excitation::search(std::uint64_t seed, int candidates) {
  Excitation best(seed);
  double least = best.condition();
  for (int k = 1; k < candidates; ++k) {
    const Excitation candidate(seed + static_cast<std::uint64_t>(k));
    const double condition = candidate.condition();
    if (condition >= least) continue;
    best = candidate;
    least = condition;
  }
  return best;
}

Moment Excitation::offset_at(double t) const {
  Moment moment{JointVector::Zero(), JointVector::Zero(), JointVector::Zero()};
  for (int k = 0; k < kHarmonics; ++k) {
    const double w = 2 * std::numbers::pi * (k + 1) / kPeriod;
    const double s = std::sin(w * t), c = std::cos(w * t);
    const JointVector a = amplitudes_.col(2 * k), b = amplitudes_.col(2 * k + 1);
    moment.q += (a * s - b * c) / w;
    moment.qd += a * c + b * s;
    moment.qdd += (b * c - a * s) * w;
  }
  return moment;
}

Moment Excitation::at(double t) const {
  const Moment offset = offset_at(t);
  return {middle_ + scale_.cwiseProduct(offset.q), scale_.cwiseProduct(offset.qd),
          scale_.cwiseProduct(offset.qdd)};
}

double Excitation::condition() const {
  Eigen::MatrixXd W(kJoints * kLook, kColumns);
  for (int k = 0; k < kLook; ++k) {
    W.middleRows<kJoints>(kJoints * k) = regressor_rows(at(kPeriod * k / kLook));
  }
  W = W * W.colwise().norm().cwiseInverse().asDiagonal();
  const Eigen::MatrixXd information = W.transpose() * W;
  const Eigen::VectorXd squares =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(information, Eigen::EigenvaluesOnly)
          .eigenvalues();
  return std::sqrt(squares.maxCoeff() / squares.minCoeff());
}

Rows regressor_rows(const Moment& moment) {
  double q[kJoints], qd[kJoints], qdd[kJoints], Y[kJoints * kRegressorColumns];
  std::copy_n(moment.q.data(), kJoints, q);
  std::copy_n(moment.qd.data(), kJoints, qd);
  std::copy_n(moment.qdd.data(), kJoints, qdd);
  puma560_identify::inverse_dynamics_regressor(q, qd, qdd, Y);
  Rows rows = Rows::Zero();
  rows.leftCols<kRegressorColumns>() =
      Eigen::Map<const Eigen::Matrix<double, kJoints, kRegressorColumns, Eigen::RowMajor>>(Y);
  for (int i = 0; i < kJoints; ++i) {
    rows(i, kRegressorColumns + i) = std::tanh(moment.qd(i) / kSlip);
  }
  return rows;
}

}  // namespace treeline::experiments
