#include <algorithm>
#include <cmath>
#include <random>

#include "interpreter/instances.hpp"
#include "oracle/group_sizes.hpp"
#include "recursion/algebra/pivot_rule.hpp"

namespace treeline {
namespace {

using LongMatrix = interpreter::Matrix<long double>;

/// Number of random changes of Lambda^-1 that explore its neighbourhood.
constexpr int kProbes = 12;

/// Distance of neighbours, a few roundings. The power identifies float: only laws in float have it.
long double reach_of(const interpreter::TaskLaw<double>& law) {
  return law.power == inverse_inertia_shape(Real::float32).power ? 0x1p-20L : 0x1p-49L;
}

/// Sizes of the diagonal of Lambda. Lambda_ii is at least 1 / A_ii if no row is relaxed. In a
/// relaxed row it goes to zero, but its rounding error is still relative to 1 / A_ii.
Eigen::VectorXd force_sizes(const LongMatrix& Lambda, const Eigen::VectorXd& terms) {
  Eigen::VectorXd sizes(terms.size());
  for (Eigen::Index i = 0; i < terms.size(); ++i) {
    const double own = std::abs(static_cast<double>(Lambda(i, i)));
    sizes(i) = terms(i) > 0 ? std::max(own, 1 / terms(i)) : own;
  }
  return sizes;
}

/// Changes each entry of A at random, by at most `reach` times its terms.
LongMatrix neighbour(const LongMatrix& A, const Eigen::VectorXd& terms, long double reach,
                     std::mt19937_64& random) {
  LongMatrix changed = A;
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      const long double sign = (random() & 1U) != 0 ? 1 : -1;
      changed(i, j) += sign * reach * std::sqrt(static_cast<long double>(terms(i) * terms(j)));
      changed(j, i) = changed(i, j);
    }
  }
  return changed;
}

/// The forces along the rows, per acceleration that the rows lack, of tasks in strict priority.
LongMatrix priority_forces(const interpreter::Points<long double>& points, const LongMatrix& A,
                           const interpreter::Vector<long double>& borders) {
  LongMatrix left = A;
  LongMatrix own = LongMatrix::Identity(A.rows(), A.cols());
  LongMatrix forces = LongMatrix::Zero(A.rows(), A.cols());
  for (const int row : interpreter::rows_by_priority(points)) {
    const long double inverse =
        interpreter::relaxed_inverse<long double>(left(row, row), borders(row));
    const interpreter::Vector<long double> share = left.col(row) * inverse;
    const interpreter::Vector<long double> column = left.col(row);
    const interpreter::Vector<long double> one = own.row(row);
    forces += one * (inverse * one.transpose());
    own -= share * one.transpose();
    left -= share * column.transpose();
  }
  return forces;
}

/// Finds the condition number by trial: the change of Lambda, relative to the size of its forces,
/// per relative change of Lambda^-1. There is no formula for it, because a relaxed row affects all
/// rows after it.
LawSizes probe(const Eigen::MatrixXd& A, const Eigen::VectorXd& terms,
               const interpreter::TaskLaw<double>& law, const Eigen::VectorXd& shares) {
  const LongMatrix exact = A.cast<long double>();
  const auto long_law = interpreter::cast<long double>(law);
  const interpreter::Vector<long double> long_shares = shares.cast<long double>();
  const LongMatrix Lambda =
      interpreter::bordered_inverse<long double>(exact, long_law, long_shares);
  const Eigen::VectorXd sizes = force_sizes(Lambda, terms);
  const Eigen::VectorXd root = sizes.cwiseSqrt();
  const long double reach = reach_of(law);
  std::mt19937_64 random;
  double condition = 1;
  for (int i = 0; i < kProbes; ++i) {
    const LongMatrix other = interpreter::bordered_inverse<long double>(
        neighbour(exact, terms, reach, random), long_law, long_shares);
    const Eigen::MatrixXd change = ((other - Lambda) / reach).cast<double>().cwiseAbs();
    for (Eigen::Index row = 0; row < A.rows(); ++row) {
      for (Eigen::Index column = 0; column < A.cols(); ++column) {
        const double size = root(row) * root(column);
        if (size > 0) condition = std::max(condition, change(row, column) / size);
      }
    }
  }
  return {condition, root * root.transpose()};
}

}  // namespace

LawSizes find_law_sizes(const Subject<double>& subject, const Eigen::VectorXd& q,
                        const Eigen::MatrixXd& Lambda_inverse, const Eigen::MatrixXd& terms,
                        const interpreter::TaskLaw<double>& law) {
  const Eigen::MatrixXd T = interpreter::law_rows<double>(subject.model, subject.points, q, law);
  const Eigen::MatrixXd size = T.cwiseAbs();
  const Eigen::MatrixXd A = T * Lambda_inverse * T.transpose();
  const Eigen::VectorXd A_terms = (size * terms * size.transpose()).diagonal();
  LawSizes found = probe(A, A_terms, law, {});
  found.Lambda = size.transpose() * found.Lambda * size;
  return found;
}

LawSizes find_law_sizes(const Eigen::MatrixXd& A, const Eigen::VectorXd& terms,
                        const interpreter::TaskLaw<double>& law, const Eigen::VectorXd& shares) {
  return probe(A, terms, law, shares);
}

Eigen::MatrixXd find_priority_steps(const interpreter::Points<double>& points,
                                    const Eigen::MatrixXd& Lambda_inverse,
                                    const Eigen::VectorXd& terms, double unit) {
  // All entries change at once, which their errors hardly do: hence by less than a rounding each.
  const long double reach = unit / 8;
  constexpr double kSafety = 4;
  const LongMatrix exact = Lambda_inverse.cast<long double>();
  const auto long_points = interpreter::cast<long double>(points);
  const interpreter::Vector<long double> borders =
      interpreter::relaxation_borders<long double>(long_points, exact.diagonal());
  const LongMatrix forces = priority_forces(long_points, exact, borders);
  const auto slope = [&](long double distance, std::mt19937_64 random) {
    const LongMatrix other =
        priority_forces(long_points, neighbour(exact, terms, distance, random), borders);
    return Eigen::MatrixXd(((other - forces) / distance).cast<double>().cwiseAbs());
  };
  Eigen::MatrixXd secant = Eigen::MatrixXd::Zero(forces.rows(), forces.cols());
  Eigen::MatrixXd tangent = secant;
  for (unsigned probe = 0; probe < kProbes; ++probe) {
    const std::mt19937_64 random(probe);
    secant = secant.cwiseMax(slope(reach, random));
    tangent = tangent.cwiseMax(slope(reach * 0x1p-10L, random));
  }
  return (secant - 2 * tangent).cwiseMax(0) * (kSafety * static_cast<double>(reach) / unit);
}

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
