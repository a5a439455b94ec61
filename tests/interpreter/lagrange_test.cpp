#include <gtest/gtest.h>

#include "interpreter/physics.hpp"

// The equations of motion compared with Lagrange's, from the two energies alone, entry by entry.
// Would catch: Coriolis terms that are wrong but do no work, and gravity on a wrong joint.

namespace treeline::tests {
namespace {

using namespace interpreter;  // NOLINT(google-build-using-namespace)

Matrix50 derivative_of_M(const Case& c, int k) {
  return derivative([&](const Digits50& t) {
    Vector50 q = c.q;
    q(k) += t;
    return mass_matrix<Digits50>(c.model, q);
  });
}

/// C from Christoffel symbols, for which Mdot - 2 C is skew-symmetric.
Matrix50 christoffel_matrix(const Case& c) {
  std::vector<Matrix50> dM;
  for (int k = 0; k < c.model.nv; ++k) dM.push_back(derivative_of_M(c, k));
  Matrix50 C = Matrix50::Zero(c.model.nv, c.model.nv);
  const auto d = [&](int k) { return dM[static_cast<std::size_t>(k)]; };
  for (int k = 0; k < c.model.nv; ++k) {
    C += d(k) * c.qd(k) / 2;
    C.col(k) += d(k) * c.qd / 2;
    C.row(k) -= (d(k) * c.qd).transpose() / 2;
  }
  return C;
}

class Lagrange : public testing::TestWithParam<std::uint64_t> {};

INSTANTIATE_TEST_SUITE_P(Seeds, Lagrange, testing::Range<std::uint64_t>(1, 9));

TEST_P(Lagrange, EquationsHoldEntryByEntry) {
  const bool mimics = GetParam() % 2 == 0;
  const Case c = random_case(
      GetParam(),
      {.joints = 5, .mix = {2, 0, 1, 0.3, 0, 1}, .mimic = mimics ? 0.5 : 0, .aligned = 0.2});
  const Vector50 g = gravity<Digits50>(c.model, c.q);
  for (int k = 0; k < c.model.nv; ++k) {
    const auto potential = [&](const Digits50& t) {
      Vector50 q = c.q;
      q(k) += t;
      return potential_energy(c.model, q);
    };
    EXPECT_LT(Digits50(abs(g(k) - derivative(potential))), kDifference * scale(g));
  }
  const Matrix50 C = christoffel_matrix(c);
  const Vector50 b = nonlinear_effects<Digits50>(c.model, c.q, c.qd) - g;
  EXPECT_LT(relative_error(b, C * c.qd), kDifference);
  const Matrix50 Mdot = derivative([&](const Digits50& t) {
    return mass_matrix<Digits50>(c.model, moved(c.model, c.q, c.qd, t));
  });
  const Matrix50 skew = Mdot - 2 * C;
  EXPECT_LT(Digits50((skew + skew.transpose()).cwiseAbs().maxCoeff()), kDifference * scale(C));
}

}  // namespace
}  // namespace treeline::tests
