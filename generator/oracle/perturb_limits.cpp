#include <Eigen/Dense>
#include <cstdint>
#include <random>

#include "oracle/limited_optimum.hpp"

namespace treeline {
namespace {

using Matrix50 = interpreter::Matrix<Digits50>;
using Vector50 = interpreter::Vector<Digits50>;
using Dense50 = Eigen::Matrix<Digits50, Eigen::Dynamic, Eigen::Dynamic>;

/// The part of a change of J's entries that keeps all relations between its rows.
Matrix50 keep_relations(const Matrix50& J, const Matrix50& change) {
  if (J.size() == 0) return change;
  Eigen::CompleteOrthogonalDecomposition<Dense50> factors(J.rows(), J.cols());
  factors.setThreshold(Digits50("1e-20"));
  factors.compute(Dense50(J));
  return J * Matrix50(factors.pseudoInverse() * change);
}

}  // namespace

LimitProblem perturbed(const LimitProblem& problem, double unit, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto drawn = [&] {
    const auto bits = static_cast<double>(engine() >> 11);
    return Digits50(unit * (bits * 0x1p-52 - 1));
  };
  const Eigen::Index nv = problem.M.rows();
  // In the unit of a velocity by which its inertia is 1.
  Vector50 scales(nv);
  for (Eigen::Index v = 0; v < nv; ++v) scales(v) = sqrt(problem.M(v, v));
  const auto change = [&] {
    Matrix50 T = Matrix50::Identity(nv, nv);
    for (Eigen::Index i = 0; i < nv; ++i) {
      for (Eigen::Index j = 0; j < nv; ++j) T(i, j) += drawn() * scales(j) / scales(i);
    }
    return T;
  };
  LimitProblem changed = problem;
  const Matrix50 of_inertia = change();
  changed.M = of_inertia.transpose() * problem.M * of_inertia;
  Matrix50 of_entries = problem.J_s;
  for (Eigen::Index i = 0; i < of_entries.rows(); ++i) {
    const Digits50 size =
        problem.J_s.row(i).transpose().cwiseQuotient(scales).cwiseAbs().maxCoeff();
    for (Eigen::Index v = 0; v < nv; ++v) of_entries(i, v) = drawn() * size * scales(v);
  }
  changed.J_s = problem.J_s * change() + keep_relations(problem.J_s, of_entries);
  changed.J_t = problem.J_t * change();
  for (Digits50& each : changed.tau) each *= 1 + drawn();
  for (Digits50& each : changed.f) each *= 1 + drawn();
  return changed;
}

}  // namespace treeline
