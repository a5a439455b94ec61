#include "emitted_links.h"

#include <gtest/gtest.h>

#include <cmath>

// Would catch: headers of loops over links that do not compile as they stand, or whose recursions
// disagree: Newton-Euler with composite bodies, both with factors of M.
namespace {

LinkState some_state() {
  LinkState state{};
  for (int i = 0; i < 9; ++i) {
    state.q[i] = 0.3 * std::cos(1.0 + i);
    state.sin_q[i] = std::sin(state.q[i]);
    state.cos_q[i] = std::cos(state.q[i]);
  }
  for (int i = 0; i < 8; ++i) {
    state.qd[i] = std::sin(2.0 * i);
    state.qdd[i] = std::cos(3.0 * i);
  }
  state.xdd_cmd[0] = 0.7;
  state.xdd_cmd[1] = -0.4;
  return state;
}

TEST(EmittedLinks, RecursionsAgree) {
  const LinkState state = some_state();
  LinkDynamics dynamics;
  links_in_c(&state, &dynamics);
  for (int i = 0; i < 8; ++i) {
    double tau = dynamics.h[i];
    for (int j = 0; j < 8; ++j) {
      tau += dynamics.M[8 * i + j] * state.qdd[j];
      EXPECT_EQ(dynamics.M[8 * i + j], dynamics.M[8 * j + i]);
    }
    EXPECT_NEAR(dynamics.tau[i], tau, 1e-12) << i;
    EXPECT_NEAR(dynamics.qdd[i], state.qdd[i], 1e-11) << i;
  }
  for (int r = 0; r < 2; ++r) {
    for (int s = 0; s < 2; ++s) {
      const double product = dynamics.Lambda[2 * r] * dynamics.Lambda_inv[s] +
                             dynamics.Lambda[2 * r + 1] * dynamics.Lambda_inv[2 + s];
      EXPECT_NEAR(product, r == s ? 1 : 0, 1e-12);
    }
  }
}

/// The potential energy's derivative, by the base's height: the robot's weight, in axes of the
/// base.
TEST(EmittedLinks, GravityOfTheBaseIsTheWeight) {
  const LinkState state = some_state();
  LinkDynamics dynamics;
  links_in_c(&state, &dynamics);
  const double square =
      dynamics.g[0] * dynamics.g[0] + dynamics.g[1] * dynamics.g[1] + dynamics.g[2] * dynamics.g[2];
  EXPECT_NEAR(std::sqrt(square), 6 * 9.81, 1e-12);
}

}  // namespace
