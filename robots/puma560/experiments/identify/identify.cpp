#include "identify.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "puma560_identify.hpp"
#include "servo/joint_friction.hpp"

namespace treeline::experiments {
namespace {

constexpr std::uint64_t kSeed = 20, kHeldOutSeed = 77, kNoiseSeed = 5;
constexpr int kCandidates = 200;
constexpr double kStep = 0.005;  // s
constexpr int kSamples = 4000;   // two periods
constexpr int kHeldOut = 2000;

/// On the joints' side of the gears: viscous N m s and Coulomb N m (Corke & Armstrong-Helouvry
/// 1994, motor friction times gear ratios; of the two directions the mean).
constexpr std::array<servo::JointFriction, kJoints> kFriction = {{{26.0, 5.80, kSlip},
                                                                  {10.6, 9.50, kSlip},
                                                                  {6.36, 3.98, kSlip},
                                                                  {1.07, 0.412, kSlip},
                                                                  {0.854, 0.427, kSlip},
                                                                  {0.554, 0.216, kSlip}}};
/// One percent of the torque limits, N m.
const JointVector kNoise{0.976, 1.864, 0.894, 0.242, 0.201, 0.213};

/// Torques of links and rotors.
JointVector rigid_torque(const Moment& moment) {
  double q[kJoints], qd[kJoints], qdd[kJoints], tau[kJoints];
  std::copy_n(moment.q.data(), kJoints, q);
  std::copy_n(moment.qd.data(), kJoints, qd);
  std::copy_n(moment.qdd.data(), kJoints, qdd);
  puma560_identify::inverse_dynamics(q, qd, qdd, tau);
  return Eigen::Map<const JointVector>(tau);
}

/// What the drives of the simulated arm give.
JointVector torque(const Moment& moment) {
  JointVector tau = rigid_torque(moment);
  for (int i = 0; i < kJoints; ++i) {
    tau(i) += servo::friction_torque(kFriction[static_cast<std::size_t>(i)], moment.qd(i));
  }
  return tau;
}

/// Samples of a motion: rows of the regressor, and torques without noise.
struct Samples {
  Eigen::MatrixXd W;
  Eigen::VectorXd tau;
};

Samples sample(const Excitation& motion, int count) {
  Samples samples{Eigen::MatrixXd(kJoints * count, kColumns), Eigen::VectorXd(kJoints * count)};
  for (int k = 0; k < count; ++k) {
    const Moment moment = motion.at(kStep * k);
    samples.W.middleRows<kJoints>(kJoints * k) = regressor_rows(moment);
    samples.tau.segment<kJoints>(kJoints * k) = torque(moment);
  }
  return samples;
}

Eigen::VectorXd with_noise(const Eigen::VectorXd& tau, Noise& noise) {
  Eigen::VectorXd noisy = tau;
  for (Eigen::Index k = 0; k < tau.size(); ++k) noisy(k) += kNoise(k % kJoints) * noise.normal();
  return noisy;
}

/// Root mean square of each joint's entries, as if `fitted` of them had been used up.
JointVector rms(const Eigen::VectorXd& entries, double fitted = 0) {
  const Eigen::Index count = entries.size() / kJoints;
  const Eigen::Map<const Eigen::Matrix<double, kJoints, Eigen::Dynamic>> by_joint(entries.data(),
                                                                                  kJoints, count);
  const double freedoms = static_cast<double>(count) - fitted / kJoints;
  return (by_joint.rowwise().squaredNorm() / freedoms).cwiseSqrt();
}

Eigen::VectorXd solve(const Eigen::MatrixXd& W, const Eigen::VectorXd& tau) {
  const Eigen::RowVectorXd lengths = W.colwise().norm();
  const Eigen::MatrixXd scaled = W * lengths.cwiseInverse().asDiagonal();
  return scaled.colPivHouseholderQr().solve(tau).cwiseQuotient(lengths.transpose());
}

void fit(const Samples& samples, const Eigen::VectorXd& noisy, Identification& result) {
  const Eigen::VectorXd plain = solve(samples.W, noisy);
  result.noise = rms(noisy - samples.W * plain, kColumns);
  const Eigen::VectorXd weights =
      result.noise.cwiseInverse().replicate(samples.W.rows() / kJoints, 1);
  const Eigen::MatrixXd W = weights.asDiagonal() * samples.W;
  result.found = solve(W, weights.cwiseProduct(noisy));
  // Of unit weight after the division by the noise: covariance (W^T W)^-1.
  const Eigen::MatrixXd information = W.transpose() * W;
  const Eigen::VectorXd scale = information.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd unit = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::MatrixXd covariance =
      unit.ldlt().solve(Eigen::MatrixXd::Identity(kColumns, kColumns));
  result.deviations = covariance.diagonal().cwiseSqrt().cwiseProduct(scale);
}

void predict(const Excitation& motion, Noise& noise, Identification& result) {
  const Samples samples = sample(motion, kHeldOut);
  const Eigen::VectorXd predicted = samples.W * result.found;
  const Eigen::VectorXd noisy = with_noise(samples.tau, noise);
  Eigen::VectorXd rigid(samples.tau.size());
  for (int k = 0; k < kHeldOut; ++k) {
    rigid.segment<kJoints>(kJoints * k) = rigid_torque(motion.at(kStep * k));
    double row[1 + 2 * kJoints] = {kStep * k};
    std::copy_n(noisy.data() + kJoints * k, kJoints, row + 1);
    std::copy_n(predicted.data() + kJoints * k, kJoints, row + 1 + kJoints);
    result.held_out.append(row);
  }
  result.held_out_error = rms(predicted - samples.tau);
  result.held_out_torque = rms(samples.tau);
  result.urdf_error = rms(rigid - samples.tau);
}

std::vector<std::string> held_out_names() {
  std::vector<std::string> names{"t_s"};
  for (const char* what : {"measured", "predicted"}) {
    for (int i = 1; i <= kJoints; ++i) names.push_back(fmt::format("{}_{}_Nm", what, i));
  }
  return names;
}

/// (found - true) / standard deviation.
Parameters normalized_errors(const Identification& result) {
  return (result.found - result.truth).cwiseQuotient(result.deviations);
}

}  // namespace

Identification identify() {
  const Excitation motion = Excitation::search(kSeed, kCandidates);
  const Samples samples = sample(motion, kSamples);
  Identification result{.held_out = report::Table(held_out_names(), kHeldOut)};
  result.condition = motion.condition();
  result.truth = solve(samples.W, samples.tau);
  result.model_error = (samples.W * result.truth - samples.tau).cwiseAbs().maxCoeff();
  Noise noise(kNoiseSeed);
  fit(samples, with_noise(samples.tau, noise), result);
  predict(Excitation(kHeldOutSeed), noise, result);
  return result;
}

bool identify_claim_holds(const Identification& result) {
  const Parameters errors = normalized_errors(result);
  const double spread = std::sqrt(errors.squaredNorm() / kColumns);
  // Of 52 normal numbers: the largest beyond 4.5 once in 3000 runs, the spread beyond 0.7 and 1.3
  // once in 400.
  return result.model_error < 1e-9 && errors.cwiseAbs().maxCoeff() < 4.5 && spread > 0.7 &&
         spread < 1.3 && (result.held_out_error.array() < 0.2 * kNoise.array()).all();
}

std::string identify_summary(const Identification& result) {
  const Parameters errors = normalized_errors(result);
  std::string text = fmt::format(
      "{} parameters from {} samples of 6 torques; condition of the motion {:.1f}\n"
      "without noise the regressor leaves {:.1e} N m\n"
      "errors of the parameters: rms {:.2f}, largest {:.2f} standard deviations\n"
      "joint  noise found  held-out torque  its error  without friction\n",
      kColumns, kSamples, result.condition, result.model_error,
      std::sqrt(errors.squaredNorm() / kColumns), errors.cwiseAbs().maxCoeff());
  for (int i = 0; i < kJoints; ++i) {
    text += fmt::format("{:<5}  {:6.3f} N m   {:8.2f} N m     {:.4f} N m  {:6.2f} N m\n", i + 1,
                        result.noise(i), result.held_out_torque(i), result.held_out_error(i),
                        result.urdf_error(i));
  }
  return text;
}

std::string identify_page_table(const Identification& result) {
  std::string text =
      "| joint | noise N m | torque, rms N m | error N m | error without friction N m |\n"
      "|---|---|---|---|---|\n";
  for (int i = 0; i < kJoints; ++i) {
    text += fmt::format("| {} | {:.2f} | {:#.3g} | {:.3f} | {:#.3g} |\n", i + 1, result.noise(i),
                        result.held_out_torque(i), result.held_out_error(i), result.urdf_error(i));
  }
  return text;
}

report::Plot identify_figure(const Identification& result) {
  report::Plot plot;
  plot.title = "PUMA 560 identified: torques of a motion that was not used";
  plot.x_label = "time, s";
  plot.x = result.held_out.column(0);
  for (int i = 0; i < kJoints; ++i) {
    const auto at = static_cast<std::size_t>(i);
    plot.panels.push_back({fmt::format("joint {}", i + 1),
                           "N m",
                           {{"measured", result.held_out.column(1 + at)},
                            {"predicted", result.held_out.column(1 + kJoints + at), true}}});
  }
  return plot;
}

}  // namespace treeline::experiments
