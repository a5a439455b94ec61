#pragma once

#include <vector>

#include "recursion/methods/choose_dependents.hpp"
#include "recursion/methods/constrained_forward_dynamics.hpp"
#include "recursion/methods/factor_mass_matrix.hpp"
#include "recursion/methods/mass_matrix.hpp"

namespace treeline {

template <class Scalar>
DenseMatrix<Scalar> rounded_matrix(const Digits50Rows& A) {
  DenseMatrix<Scalar> result(static_cast<std::size_t>(A.rows()),
                             static_cast<std::size_t>(A.cols()));
  for (std::size_t i = 0; i < result.rows(); ++i) {
    for (std::size_t j = 0; j < result.cols(); ++j) {
      result(i, j) = rounded<Scalar>(A(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
    }
  }
  return result;
}

/// M seen from the independent velocities: N = [M_DI + M_DD G], M_s = M_II + M_ID G + G^T N.
template <class Scalar>
struct ReducedInertia {
  DenseMatrix<Scalar> N, M_s;
};

template <class Scalar>
ReducedInertia<Scalar> reduce_inertia(const DenseMatrix<Scalar>& M, const DenseMatrix<Scalar>& G,
                                      const CoupledVelocities& coupled) {
  const auto& I = coupled.independent;
  const auto& D = coupled.dependent;
  ReducedInertia<Scalar> reduced{DenseMatrix<Scalar>(D.size(), I.size()),
                                 DenseMatrix<Scalar>(I.size(), I.size())};
  for (std::size_t d = 0; d < D.size(); ++d) {
    for (std::size_t i = 0; i < I.size(); ++i) {
      Scalar sum = M(D[d], I[i]);
      for (std::size_t e = 0; e < D.size(); ++e) sum = sum + M(D[d], D[e]) * G(e, i);
      reduced.N(d, i) = sum;
    }
  }
  for (std::size_t i = 0; i < I.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      Scalar sum = M(I[i], I[j]);
      for (std::size_t d = 0; d < D.size(); ++d) {
        sum = sum + M(I[i], D[d]) * G(d, j) + G(d, i) * reduced.N(d, j);
      }
      reduced.M_s(i, j) = sum;
      reduced.M_s(j, i) = sum;
    }
  }
  return reduced;
}

/// S c: accelerations of the dependent velocities that lead the couplings back,
///     c = -stabilisation[0] C qd - stabilisation[1] error.
template <class Scalar>
std::vector<Scalar> leading_back(const LoopRows<Scalar>& rows, const DenseMatrix<Scalar>& S,
                                 const CoupledVelocities& coupled,
                                 const ConstrainedInputs<Scalar>& inputs) {
  const auto velocities = velocities_of(rows.J, inputs.qd);
  std::vector<Scalar> g(coupled.dependent.size(), Scalar(0.0));
  for (std::size_t r = 0; r < coupled.rows.size(); ++r) {
    const std::size_t row = coupled.rows[r];
    const Scalar c =
        -(velocities[row] * inputs.stabilisation[0] + rows.errors[row] * inputs.stabilisation[1]);
    for (std::size_t d = 0; d < g.size(); ++d) g[d] = g[d] + S(d, r) * c;
  }
  return g;
}

/// Forces in the direction of the independent velocities: (1, G^T) x.
template <class Scalar>
std::vector<Scalar> projected(const std::vector<Scalar>& x, const DenseMatrix<Scalar>& G,
                              const CoupledVelocities& coupled) {
  std::vector<Scalar> result;
  for (std::size_t i = 0; i < coupled.independent.size(); ++i) {
    result.push_back(x[coupled.independent[i]]);
    for (std::size_t d = 0; d < coupled.dependent.size(); ++d) {
      result[i] = result[i] + G(d, i) * x[coupled.dependent[d]];
    }
  }
  return result;
}

/// b + A x.
template <class Scalar>
std::vector<Scalar> plus_product(std::vector<Scalar> b, const DenseMatrix<Scalar>& A,
                                 const std::vector<Scalar>& x) {
  for (std::size_t i = 0; i < b.size(); ++i) {
    for (std::size_t j = 0; j < x.size(); ++j) b[i] = b[i] + A(i, j) * x[j];
  }
  return b;
}

/// Motion under joint forces while couplings hold, with the velocities that they determine
/// eliminated: qdd_D = G qdd_I + g in M qdd = net + C^T f, net = tau - b - g + J_ext^T f_ext. The
/// projection by (1, G^T) removes the forces,
///     M_s qdd_I = (1, G^T) (net - M g),
/// and the rows of D give them: f = S^T (M qdd - net)_D. A coupling that depends on those before it
/// has force 0. (Cluster joints with constant Jacobians: Chignoli, Adrian, Kim, Wensing 2023.)
template <class Scalar>
ConstrainedMotion<Scalar> eliminated_forward_dynamics(const Tree<Scalar>& tree,
                                                      const std::vector<JointTransform<Scalar>>& X,
                                                      const ConstrainedInputs<Scalar>& inputs,
                                                      const CoupledVelocities& coupled) {
  const auto& D = coupled.dependent;
  const auto G = rounded_matrix<Scalar>(coupled.G), S = rounded_matrix<Scalar>(coupled.S);
  const auto rows = loop_rows(tree, X, inputs.q, inputs.qd);
  const auto M = mass_matrix(tree, X);
  const auto reduced = reduce_inertia(M, G, coupled);
  const auto g = leading_back(rows, S, coupled, inputs);
  std::vector<Scalar> net = inverse_dynamics<Scalar>(tree, X, {inputs.qd, {}}, inputs.applied);
  for (std::size_t v = 0; v < net.size(); ++v) {
    net[v] = inputs.tau[v] - net[v];
    for (std::size_t d = 0; d < D.size(); ++d) net[v] = net[v] - M(v, D[d]) * g[d];
  }
  const auto qdd_I = solve(factor_ltdl(reduced.M_s), projected(net, G, coupled));
  const auto qdd_D = plus_product(g, G, qdd_I);
  ConstrainedMotion<Scalar> motion{std::vector<Scalar>(net.size()),
                                   std::vector<Scalar>(rows.J.rows(), Scalar(0.0))};
  for (std::size_t i = 0; i < qdd_I.size(); ++i) motion.qdd[coupled.independent[i]] = qdd_I[i];
  std::vector<Scalar> lacking;  // M qdd - net
  for (std::size_t d = 0; d < D.size(); ++d) {
    motion.qdd[D[d]] = qdd_D[d];
    lacking.push_back(-net[D[d]]);
  }
  lacking = plus_product(lacking, reduced.N, qdd_I);
  for (std::size_t r = 0; r < coupled.rows.size(); ++r) {
    Scalar& f = motion.f[coupled.rows[r]];
    for (std::size_t d = 0; d < D.size(); ++d) f = f + S(d, r) * lacking[d];
  }
  return motion;
}

}  // namespace treeline
