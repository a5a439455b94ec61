#include <algorithm>
#include <random>

#include "interpreter/loop_instances.hpp"
#include "oracle/entries.hpp"
#include "oracle/group_sizes.hpp"
#include "oracle/symmetric_matrices.hpp"
#include "recursion/algebra/pivot_rule.hpp"

namespace treeline {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using LongMatrix = interpreter::Matrix<long double>;

/// Number of random changes that explore a neighbourhood of J.
constexpr int kTrials = 12;

/// A few roundings. The power identifies float: only laws in float have it.
long double few_roundings(const interpreter::TaskLaw<double>& law) {
  return law.power == inverse_inertia_shape(Real::float32).power ? 0x1p-20L : 0x1p-49L;
}

/// Largest entry of each row; 1 of rows without any.
VectorXd largest_in_rows(const MatrixXd& A) {
  VectorXd largest = A.rowwise().maxCoeff();
  for (double& each : largest) each = each > 0 ? each : 1;
  return largest;
}

/// Sizes of J_D^+: its rows have the unit of their velocity, its columns one over that of their
/// row.
MatrixXd sizes_of_inverse(const LongMatrix& inverse, const MatrixXd& J_sizes) {
  const VectorXd units = largest_in_rows(J_sizes);
  const MatrixXd entries = inverse.cast<double>().cwiseAbs() * units.asDiagonal();
  const VectorXd columns =
      (units.cwiseInverse().asDiagonal() * J_sizes).colwise().norm().transpose();
  VectorXd rows = entries.rowwise().maxCoeff();
  for (Eigen::Index k = 0; k < rows.size(); ++k) {
    if (columns(k) > 0) rows(k) = std::max(rows(k), 1 / columns(k));
  }
  return rows * units.cwiseInverse().transpose();
}

LongMatrix changed(const LongMatrix& J, const MatrixXd& sizes, long double reach,
                   std::mt19937_64& random) {
  LongMatrix other = J;
  for (Eigen::Index i = 0; i < J.rows(); ++i) {
    for (Eigen::Index j = 0; j < J.cols(); ++j) {
      other(i, j) +=
          ((random() & 1U) != 0 ? reach : -reach) * static_cast<long double>(sizes(i, j));
    }
  }
  return other;
}

/// M seen from the independent velocities, and the sizes of its diagonal's terms.
double condition_of_rest(const interpreter::DependentRates<double>& rates, const MatrixXd& M) {
  const MatrixXd P = interpreter::permitted_motions(rates, M.rows());
  const MatrixXd M_s = P.transpose() * M * P;
  const MatrixXd size = P.cwiseAbs().transpose() * M.cwiseAbs() * P.cwiseAbs();
  return scaled_condition(M_s, size.diagonal());
}

/// The rest after dependent velocities are eliminated: M_s^-1, and sizes of how they follow.
struct Rest {
  interpreter::DependentRates<double> rates;
  MatrixXd P, inertia_inverse, G;  ///< of the inverse: the matrix itself
  MatrixXd J_c, J_c_sizes;         ///< of tasks

  Rest(const EliminationTerms& terms, const interpreter::TaskLaw<double>& law,
       const MatrixXd& inverse)
      : rates(interpreter::dependent_rates<double>(terms.J, law)),
        P(interpreter::permitted_motions(rates, terms.M.rows())) {
    const MatrixXd M_s = P.transpose() * terms.M * P;
    inertia_inverse = inverse_of_symmetric(M_s);
    G = inverse * terms.J_sizes(rates.rows, rates.independent);
  }

  /// The rows of tasks, which are behind the `held` rows.
  void take_tasks(const EliminationTerms& terms, Eigen::Index held) {
    const auto tasks = terms.J.rows() - held;
    J_c = terms.J.bottomRows(tasks) * P;
    const MatrixXd sizes = terms.J_sizes.bottomRows(tasks);
    J_c_sizes = sizes(Eigen::all, rates.independent) + sizes(Eigen::all, rates.dependent) * G;
  }

  [[nodiscard]] LawSizes of_tasks(const interpreter::TaskLaw<double>& law) const {
    if (J_c.rows() == 0) return {1, MatrixXd(0, 0)};
    const MatrixXd A = J_c * inertia_inverse * J_c.transpose();
    const MatrixXd terms = J_c_sizes * inertia_inverse.cwiseAbs() * J_c_sizes.transpose();
    return find_law_sizes(A, terms.diagonal(), interpreter::law_behind_pivots(law));
  }
};

VectorXd with_least_share(const VectorXd& sizes) {
  return sizes.size() > 0 ? VectorXd(sizes.cwiseMax(0x1p-10 * sizes.maxCoeff())) : sizes;
}

}  // namespace

LawSizes find_elimination_sizes(const EliminationTerms& terms,
                                const interpreter::TaskLaw<double>& law) {
  const auto rates = interpreter::dependent_rates<double>(terms.J, law);
  const LongMatrix J_D =
      interpreter::Matrix<double>(terms.J(rates.rows, rates.dependent)).cast<long double>();
  const MatrixXd entries = terms.J_sizes(rates.rows, rates.dependent);
  const auto long_law = interpreter::cast<long double>(law);
  const LongMatrix inverse = interpreter::inverse_by_columns<long double>(J_D, long_law);
  const MatrixXd sizes = sizes_of_inverse(inverse, entries);
  const long double reach = few_roundings(law);
  std::mt19937_64 random(1);
  double condition = 1;
  for (int i = 0; i < kTrials; ++i) {
    const LongMatrix other = interpreter::inverse_by_columns<long double>(
        changed(J_D, entries, reach, random), long_law);
    const MatrixXd change = ((other - inverse) / reach).cast<double>().cwiseAbs();
    condition = std::max(condition, change.cwiseQuotient(sizes).maxCoeff());
  }
  return {condition * condition_of_rest(rates, terms.M), sizes};
}

std::vector<double> eliminated_sizes(const EliminationTerms& terms,
                                     const interpreter::TaskLaw<double>& law,
                                     const MatrixXd& inverse) {
  const Rest rest(terms, law, inverse);
  const auto& I = rest.rates.independent;
  const auto& D = rest.rates.dependent;
  const VectorXd g = inverse * VectorXd(terms.asked(rest.rates.rows));
  const VectorXd forces = terms.forces + terms.M_sizes(Eigen::all, D) * g;
  const VectorXd x = rest.inertia_inverse.cwiseAbs() *
                     (VectorXd(forces(I)) + rest.G.transpose() * VectorXd(forces(D)));
  VectorXd qdd(terms.M.rows());
  qdd(I) = x;
  qdd(D) = g + rest.G * x;
  VectorXd f = VectorXd::Zero(terms.J.rows());
  f(rest.rates.rows) =
      inverse.transpose() * (VectorXd(forces(D)) + terms.M_sizes(D, Eigen::all) * qdd);
  std::vector<double> entries = entries_of(qdd);
  append(f, entries);
  return entries;
}

double condition_of_tasks(const EliminationTerms& terms, const interpreter::TaskLaw<double>& law,
                          const MatrixXd& inverse) {
  Rest rest(terms, law, inverse);
  rest.take_tasks(terms, inverse.cols());
  return rest.of_tasks(law).condition;
}

std::vector<double> eliminated_torque_sizes(const EliminationTerms& terms,
                                            const interpreter::TaskLaw<double>& law,
                                            const MatrixXd& inverse) {
  Rest rest(terms, law, inverse);
  const auto held = inverse.cols();  // every row of the loops is kept
  rest.take_tasks(terms, held);
  const auto& I = rest.rates.independent;
  const auto& D = rest.rates.dependent;
  const auto tasks = terms.J.rows() - held;
  const VectorXd r = inverse * VectorXd(terms.asked(rest.rates.rows)) +
                     rest.G * VectorXd(terms.qdd_0(I)) + VectorXd(terms.qdd_0(D));
  const VectorXd inertial = terms.M_sizes(Eigen::all, D) * r;
  const MatrixXd M_s_inverse = rest.inertia_inverse.cwiseAbs();
  VectorXd drive = VectorXd(inertial(I)) + rest.G.transpose() * VectorXd(inertial(D));
  VectorXd tau = VectorXd::Zero(terms.M.rows());
  tau(I) = VectorXd(terms.forces(I)) + rest.G.transpose() * VectorXd(terms.forces(D));
  if (tasks > 0) {
    const MatrixXd J_t = terms.J_sizes.bottomRows(tasks);
    const VectorXd errors = VectorXd(terms.asked.tail(tasks)) + J_t * terms.qdd_0 +
                            J_t(Eigen::all, D) * r + rest.J_c_sizes * (M_s_inverse * drive);
    const VectorXd asked = rest.J_c_sizes.transpose() * (rest.of_tasks(law).Lambda * errors);
    drive += asked;
    tau(I) += asked;
  }
  const VectorXd y = M_s_inverse * drive;
  VectorXd change(terms.M.rows());
  change(I) = y;
  change(D) = rest.G * y + r;
  VectorXd f = VectorXd::Zero(held);
  f(rest.rates.rows) =
      inverse.transpose() * (VectorXd(terms.forces(D)) + terms.M_sizes(D, Eigen::all) * change);
  std::vector<double> entries = entries_of(with_least_share(tau));
  append(with_least_share(f), entries);
  return entries;
}

}  // namespace treeline
