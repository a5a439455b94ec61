#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

#include "inspect/inspect_robot.hpp"
#include "interpreter/instances.hpp"
#include "oracle/symmetric_matrices.hpp"

namespace treeline {
namespace {

using Dense = Eigen::MatrixXd;

/// J U^-T; empty if M is not positive definite.
Dense find_columns(const interpreter::Model<double>& model,
                   const interpreter::Points<double>& points,
                   const interpreter::Vector<double>& q) {
  const Dense M = interpreter::mass_matrix<double>(model, q);
  const Dense J = interpreter::jacobian<double>(model, points, q);
  // In reverse order of joints, the upper triangular factor is a lower one.
  const Eigen::LLT<Dense> factor(M.reverse());
  if (factor.info() != Eigen::Success) return {};
  const Dense turned = J.rowwise().reverse();
  const Dense columns = factor.matrixL().solve(turned.transpose()).transpose();
  return columns.rowwise().reverse();
}

std::optional<MassRatio> compare_columns(const Dense& columns) {
  const Dense A = columns * columns.transpose();
  if (!(A.diagonal().minCoeff() > 0)) return std::nullopt;
  const Dense scaled = A.diagonal().cwiseSqrt().cwiseInverse().asDiagonal() * columns;
  const Eigen::VectorXd sizes = scaled.colwise().squaredNorm();
  MassRatio ratio;
  Dense equal = scaled;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < sizes.size(); ++i) {
    if (!(sizes(i) > 0)) continue;
    equal.col(i) /= std::sqrt(sizes(i));
    if (sizes(i) > sizes(ratio.light)) ratio.light = static_cast<int>(i);
    if (sizes(i) < least) {
      ratio.heavy = static_cast<int>(i);
      least = sizes(i);
    }
  }
  ratio.share = sizes(ratio.light) / least;
  ratio.condition = unit_condition(A) / unit_condition(equal * equal.transpose());
  return ratio;
}

}  // namespace

std::optional<MassRatio> find_mass_ratio(const interpreter::Model<double>& model,
                                         const interpreter::Points<double>& points,
                                         std::span<const interpreter::Vector<double>> states) {
  std::optional<MassRatio> least;
  for (const auto& q : states) {
    const Dense columns = find_columns(model, points, q);
    if (columns.size() == 0) return std::nullopt;
    const auto found = compare_columns(columns);
    // NaN if both condition numbers are infinite. The task is to blame then.
    if (!found || std::isnan(found->condition)) return std::nullopt;
    if (!least || found->condition < least->condition) least = found;
  }
  return least;
}

double unit_condition(const Eigen::MatrixXd& A) {
  return scaled_condition(A, A.diagonal());
}

}  // namespace treeline
