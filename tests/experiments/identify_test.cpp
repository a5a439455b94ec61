// The identification of the PUMA 560 by its claims. Would catch: columns of the generated regressor
// that are not those of the generated dynamics; standard deviations that promise too much or too
// little; friction or rotors that are given to the wrong joint.
#include "identify.hpp"

#include <gtest/gtest.h>

namespace treeline::experiments {
namespace {

const Identification& result() {
  static const Identification kResult = identify();
  return kResult;
}

TEST(Identify, ClaimHolds) {
  EXPECT_TRUE(identify_claim_holds(result())) << identify_summary(result());
}

// The last columns are those of joints: rotors of joints 3 to 6, viscous and Coulomb friction.
// Their true values are the scene's and the program's, not fitted ones.
TEST(Identify, TellsRotorsAndFrictionApart) {
  const Parameters& truth = result().truth;
  const double rotors[] = {0.827, 0.200, 0.179, 0.193};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(truth(36 + i), rotors[i], 1e-9);
  const double viscous[] = {5.80, 9.50, 3.98, 0.412, 0.427, 0.216};
  const double coulomb[] = {26.0, 10.6, 6.36, 1.07, 0.854, 0.554};
  for (int i = 0; i < kJoints; ++i) {
    EXPECT_NEAR(truth(40 + i), viscous[i], 1e-9);
    EXPECT_NEAR(truth(46 + i), coulomb[i], 1e-9);
  }
}

TEST(Identify, FindsTheNoise) {
  const double noise[] = {0.976, 1.864, 0.894, 0.242, 0.201, 0.213};
  // Of 4000 samples a standard deviation is known to 1.1 %.
  for (int i = 0; i < kJoints; ++i) EXPECT_NEAR(result().noise(i) / noise[i], 1, 0.05);
}

// What a motion tells depends on the motion: a condition of 11 with the one that is searched.
TEST(Identify, MovesTheArmWell) {
  EXPECT_LT(result().condition, 20);
}

}  // namespace
}  // namespace treeline::experiments
