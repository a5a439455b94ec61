#include <gtest/gtest.h>

#include "mechanism/build_steps.hpp"
#include "random_mechanism.hpp"

// The price by which frames are placed. Would catch: a price that differs from the cost of the link
// as it then is built, which absorbs the turn by functions of angles in 50 digits.

namespace treeline::tests {
namespace {

/// One of the 24 rotations by quarter turns, or about some axes by other angles too.
Digits50Matrix3 draw_rotation(Rng& rng) {
  Digits50Matrix3 cycle = Digits50Matrix3::Zero();
  cycle(0, 2) = cycle(1, 0) = cycle(2, 1) = 1;
  Digits50Matrix3 R = Digits50Matrix3::Identity();
  for (int axis = 0; axis < 3; ++axis) {
    const Digits50 angle = Digits50(rng.below(4)) * half_pi() +
                           (rng.below(2) == 0 ? Digits50(rng.uniform(-1.4, 1.4)) : Digits50(0));
    R = (cycle * rotation_z(angle) * R).eval();
  }
  return R;
}

MovingLink draw_link(Rng& rng) {
  MovingLink link;
  link.parent = rng.below(3) - 1;
  for (int i = 0; i < 3; ++i) link.placement.p(i) = rng.below(2) * rng.uniform(-1, 1);
  link.placement.R = draw_rotation(rng);
  switch (rng.below(4)) {
    case 0:  // the turn at the end and the offset cancel
      link.offset = -right_turn(link.placement.R);
      break;
    case 1:
      link.offset = rng.uniform(-3, 3);
      break;
    default:
      break;
  }
  return link;
}

TEST(AbsorbTurn, ThePriceIsTheCostOfTheLinkAsItIsBuilt) {
  Rng rng(1);
  const Resolution resolution{Digits50(4.4e-16), Digits50(4.4e-16)};
  int absorbed = 0;
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE(round);
    MovingLink link = draw_link(rng);
    link.placement = resolved(link.placement, resolution);
    const int before = link_cost(link);
    const int price = absorbed_cost(link, link.placement, resolution);
    absorb_turn(link, resolution, nullptr);
    EXPECT_EQ(price, link_cost(link));
    absorbed += price < before ? 1 : 0;
  }
  EXPECT_GT(absorbed, 40);  // links of both kinds were drawn
  EXPECT_LT(absorbed, 360);
}

}  // namespace
}  // namespace treeline::tests
