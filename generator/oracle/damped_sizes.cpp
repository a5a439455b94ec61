#include "oracle/damped_sizes.hpp"

#include <algorithm>

namespace treeline {

DampedSizes find_damped_sizes(const Eigen::MatrixXd& Lambda_inverse, const Eigen::MatrixXd& terms,
                              const interpreter::Damping<double>& damping) {
  const interpreter::ScaledEigensystem<double> of(Lambda_inverse, damping.effective_mass_limits);
  const Eigen::VectorXd damped =
      interpreter::damped_eigenvalues<double>(of.values, damping.resolution);
  const auto S = of.roots.asDiagonal();
  const Eigen::MatrixXd inverse =
      of.directions * damped.cwiseInverse().asDiagonal() * of.directions.transpose();
  const Eigen::MatrixXd scaled_terms = S * terms * S;
  const double largest = scaled_terms.norm();
  const Eigen::MatrixXd Lambda = S * inverse * S;
  return {Lambda.cwiseAbs(), std::max(1.0, largest),
          std::max(1.0, largest) / std::min(1.0, damped.minCoeff())};
}

}  // namespace treeline
