#pragma once

#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>

#include "bench/peers/pinocchio/solver.hpp"

namespace treeline::peer::pin {

/// Derivatives of inverse dynamics. `out` receives three matrices: with respect to q, to qd, and
/// the upper triangle of that with respect to qdd. Entries that are zero in every state are not
/// written.
template <class Scalar>
void rnea_derivatives(Solver<Scalar>& s, const Scalar* const* in, Scalar* out) {
  s.load_motion(in);
  const Eigen::Index n = s.model.nv;
  Eigen::Map<Matrix<Scalar>> by_q(out, n, n);
  Eigen::Map<Matrix<Scalar>> by_qd(out + n * n, n, n);
  Eigen::Map<Matrix<Scalar>> by_qdd(out + 2 * n * n, n, n);
  pinocchio::computeRNEADerivatives(s.model, s.data, s.q, s.qd, s.drive, by_q, by_qd, by_qdd);
}

template <class Scalar>
void aba_derivatives(Solver<Scalar>& s, const Scalar* const* in, Scalar* out) {
  s.load_motion(in);
  const Eigen::Index n = s.model.nv;
  Eigen::Map<Matrix<Scalar>> by_q(out, n, n);
  Eigen::Map<Matrix<Scalar>> by_qd(out + n * n, n, n);
  Eigen::Map<Matrix<Scalar>> by_tau(out + 2 * n * n, n, n);
  pinocchio::computeABADerivatives(s.model, s.data, s.q, s.qd, s.drive, by_q, by_qd, by_tau);
}

}  // namespace treeline::peer::pin
