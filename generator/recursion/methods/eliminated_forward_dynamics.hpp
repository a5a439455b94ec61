#pragma once

#include <vector>

#include "recursion/algebra/orthogonal_columns.hpp"
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

/// How couplings make dependent velocities follow: qd_D = G qd_I + S c with constants.
template <class Scalar>
struct CoupledRates {
  DenseMatrix<Scalar> G, S;

  explicit CoupledRates(const CoupledVelocities& coupled)
      : G(rounded_matrix<Scalar>(coupled.G)), S(rounded_matrix<Scalar>(coupled.S)) {}

  /// S c.
  [[nodiscard]] std::vector<Scalar> led_by(const std::vector<Scalar>& c) const {
    std::vector<Scalar> g(S.rows(), Scalar(0.0));
    for (std::size_t r = 0; r < c.size(); ++r) {
      for (std::size_t d = 0; d < g.size(); ++d) g[d] = g[d] + S(d, r) * c[r];
    }
    return g;
  }
  /// S^T x.
  [[nodiscard]] std::vector<Scalar> forces_for(const std::vector<Scalar>& x) const {
    std::vector<Scalar> f(S.cols(), Scalar(0.0));
    for (std::size_t r = 0; r < f.size(); ++r) {
      for (std::size_t d = 0; d < x.size(); ++d) f[r] = f[r] + S(d, r) * x[d];
    }
    return f;
  }
};

/// How loops make dependent velocities follow in a pose: S = J_D^+. A column yields where the
/// columns before it leave nothing of it.
template <class Scalar>
class LoopedRates {
 public:
  DenseMatrix<Scalar> G;

  LoopedRates(const DenseMatrix<Scalar>& J, const LoopedVelocities& looped)
      : G(looped.dependent.size(), looped.independent.size()),
        solver_(columns_in(J, looped), looped.rule) {
    for (std::size_t i = 0; i < looped.independent.size(); ++i) {
      std::vector<Scalar> column;
      for (const std::size_t row : looped.rows) column.push_back(J(row, looped.independent[i]));
      const auto moved = solver_.solve(std::move(column));
      for (std::size_t d = 0; d < moved.size(); ++d) G(d, i) = -moved[d];
    }
  }

  [[nodiscard]] std::vector<Scalar> led_by(const std::vector<Scalar>& c) const {
    return solver_.solve(c);
  }
  [[nodiscard]] std::vector<Scalar> forces_for(const std::vector<Scalar>& x) const {
    return solver_.solve_transposed(x);
  }

 private:
  /// J_D.
  static DenseMatrix<Scalar> columns_in(const DenseMatrix<Scalar>& J,
                                        const LoopedVelocities& looped) {
    DenseMatrix<Scalar> J_D(looped.rows.size(), looped.dependent.size());
    for (std::size_t i = 0; i < J_D.rows(); ++i) {
      for (std::size_t d = 0; d < J_D.cols(); ++d) {
        J_D(i, d) = J(looped.rows[i], looped.dependent[d]);
      }
    }
    return J_D;
  }

  OrthogonalColumns<Scalar> solver_;
};

template <class Scalar>
CoupledRates<Scalar> rates_of(const DenseMatrix<Scalar>&, const CoupledVelocities& coupled) {
  return CoupledRates<Scalar>(coupled);
}
template <class Scalar>
LoopedRates<Scalar> rates_of(const DenseMatrix<Scalar>& J, const LoopedVelocities& looped) {
  return {J, looped};
}

/// M seen from the independent velocities: N = [M_DI + M_DD G], M_s = M_II + M_ID G + G^T N.
template <class Scalar>
struct ReducedInertia {
  DenseMatrix<Scalar> N, M_s;
};

template <class Scalar, class Velocities>
ReducedInertia<Scalar> reduce_inertia(const DenseMatrix<Scalar>& M, const DenseMatrix<Scalar>& G,
                                      const Velocities& velocities) {
  const auto& I = velocities.independent;
  const auto& D = velocities.dependent;
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

/// Accelerations that the rows lack where the independent velocities have none, with what leads
/// them back: c = -Jd qd - stabilisation[0] J qd - stabilisation[1] error.
template <class Scalar>
std::vector<Scalar> asked_of_rows(const LoopRows<Scalar>& rows,
                                  const std::vector<std::size_t>& kept,
                                  const ConstrainedInputs<Scalar>& inputs) {
  const auto speeds = velocities_of(rows.J, inputs.qd);
  std::vector<Scalar> c;
  for (const std::size_t row : kept) {
    c.push_back(-(rows.bias[row] + speeds[row] * inputs.stabilisation[0] +
                  rows.errors[row] * inputs.stabilisation[1]));
  }
  return c;
}

/// Forces in the direction of the independent velocities: (1, G^T) x.
template <class Scalar, class Velocities>
std::vector<Scalar> projected(const std::vector<Scalar>& x, const DenseMatrix<Scalar>& G,
                              const Velocities& velocities) {
  std::vector<Scalar> result;
  for (std::size_t i = 0; i < velocities.independent.size(); ++i) {
    result.push_back(x[velocities.independent[i]]);
    for (std::size_t d = 0; d < velocities.dependent.size(); ++d) {
      result[i] = result[i] + G(d, i) * x[velocities.dependent[d]];
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

/// Motion under joint forces while rows hold, with the velocities that they determine eliminated:
/// qdd_D = G qdd_I + g in M qdd = net + J^T f, net = tau - b - g + J_ext^T f_ext. The projection by
/// (1, G^T) removes the forces,
///     M_s qdd_I = (1, G^T) (net - M g),
/// and the rows of D give them: f = S^T (M qdd - net)_D. A row that depends on those before it has
/// force 0. `velocities`: `CoupledVelocities`, whose G and S are constant, or `LoopedVelocities`.
/// (Cluster joints: Chignoli, Adrian, Kim, Wensing 2023.)
template <class Scalar, class Velocities>
ConstrainedMotion<Scalar> eliminated_forward_dynamics(const Tree<Scalar>& tree,
                                                      const std::vector<JointTransform<Scalar>>& X,
                                                      const ConstrainedInputs<Scalar>& inputs,
                                                      const Velocities& velocities) {
  const auto& I = velocities.independent;
  const auto& D = velocities.dependent;
  const auto rows = loop_rows(tree, X, inputs.q, inputs.qd);
  const auto rates = rates_of(rows.J, velocities);
  const auto M = mass_matrix(tree, X);
  const auto reduced = reduce_inertia(M, rates.G, velocities);
  const auto g = rates.led_by(asked_of_rows(rows, velocities.rows, inputs));
  std::vector<Scalar> net = inverse_dynamics<Scalar>(tree, X, {inputs.qd, {}}, inputs.applied);
  for (std::size_t v = 0; v < net.size(); ++v) {
    net[v] = inputs.tau[v] - net[v];
    for (std::size_t d = 0; d < D.size(); ++d) net[v] = net[v] - M(v, D[d]) * g[d];
  }
  const auto qdd_I = solve(factor_ltdl(reduced.M_s), projected(net, rates.G, velocities));
  const auto qdd_D = plus_product(g, rates.G, qdd_I);
  ConstrainedMotion<Scalar> motion{std::vector<Scalar>(net.size()),
                                   std::vector<Scalar>(rows.J.rows(), Scalar(0.0))};
  for (std::size_t i = 0; i < qdd_I.size(); ++i) motion.qdd[I[i]] = qdd_I[i];
  std::vector<Scalar> lacking;  // M qdd - net
  for (std::size_t d = 0; d < D.size(); ++d) {
    motion.qdd[D[d]] = qdd_D[d];
    lacking.push_back(-net[D[d]]);
  }
  const auto f = rates.forces_for(plus_product(lacking, reduced.N, qdd_I));
  for (std::size_t r = 0; r < f.size(); ++r) motion.f[velocities.rows[r]] = f[r];
  return motion;
}

}  // namespace treeline
