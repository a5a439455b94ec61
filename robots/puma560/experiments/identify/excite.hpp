#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace treeline::experiments {

constexpr int kJoints = 6;
/// Base parameters of links and rotors, and viscous friction of the joints.
constexpr int kRegressorColumns = 46;
/// With a column of Coulomb friction for each joint.
constexpr int kColumns = kRegressorColumns + kJoints;

using JointVector = Eigen::Matrix<double, kJoints, 1>;
using Rows = Eigen::Matrix<double, kJoints, kColumns, Eigen::RowMajor>;

/// Joint motion at an instant.
struct Moment {
  JointVector q, qd, qdd;
};

/// A periodic motion: finite Fourier series about a middle pose (Swevers et al. 1997).
class Excitation {
 public:
  static constexpr double kPeriod = 10;  ///< s
  static constexpr int kHarmonics = 5;

  /// A random motion within the joints' limits and speeds that the arm can follow.
  explicit Excitation(std::uint64_t seed);
  /// The one of so many random motions whose rows have the least condition number, each column
  /// divided by its length.
  static Excitation search(std::uint64_t seed, int candidates);

  [[nodiscard]] Moment at(double t) const;
  [[nodiscard]] double condition() const;

 private:
  [[nodiscard]] Moment offset_at(double t) const;

  Eigen::Matrix<double, kJoints, 2 * kHarmonics> amplitudes_;
  JointVector middle_, scale_;
};

/// The generated regressor with columns of Coulomb friction, whose sign is tanh(qd / `kSlip`).
Rows regressor_rows(const Moment& moment);
inline constexpr double kSlip = 0.05;  ///< rad/s

/// Uniform in [-1, 1), and normal with unit deviation: the same numbers on every host.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : state_(seed) {}
  double uniform();
  double normal();

 private:
  std::uint64_t state_;
};

}  // namespace treeline::experiments
