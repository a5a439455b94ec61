// Would catch: two front ends that command at once, a hand-over that nobody asked for, a front end
// that keeps the command after it has gone or has long been silent.
#include "drive/authority.hpp"

#include <gtest/gtest.h>

#include "drive/rate_limit.hpp"

namespace treeline::drive {
namespace {

TEST(Authority, FirstComesFirst) {
  Authority authority;
  EXPECT_FALSE(authority.holder());
  EXPECT_TRUE(authority.obeys(1, 0.0));
  EXPECT_FALSE(authority.obeys(2, 0.1));
  EXPECT_EQ(authority.holder(), 1);
}

TEST(Authority, IsHandedOverByRequest) {
  Authority authority;
  EXPECT_TRUE(authority.take(1, 0.0));
  EXPECT_FALSE(authority.take(2, 1.0));
  EXPECT_FALSE(authority.give(2, 1.0));
  EXPECT_TRUE(authority.obeys(1, 1.0));
  EXPECT_TRUE(authority.give(1, 2.0));
  EXPECT_EQ(authority.holder(), 2);
  EXPECT_FALSE(authority.obeys(1, 2.0));
  EXPECT_TRUE(authority.give(2, 3.0));
  EXPECT_FALSE(authority.holder());
}

TEST(Authority, SilenceLosesIt) {
  Authority authority;
  EXPECT_TRUE(authority.obeys(1, 0.0));
  EXPECT_TRUE(authority.obeys(1, 5.0));
  EXPECT_FALSE(authority.take(2, 5.0 + Authority::kSilence));
  EXPECT_TRUE(authority.take(2, 5.1 + Authority::kSilence));
  EXPECT_FALSE(authority.obeys(1, 16.0));
}

TEST(Authority, WhoLeavesLosesIt) {
  Authority authority;
  EXPECT_TRUE(authority.obeys(1, 0.0));
  EXPECT_FALSE(authority.take(2, 0.0));
  EXPECT_FALSE(authority.take(3, 0.0));
  authority.leave(3, 0.1);  // the last who asked has gone, and with him the request
  authority.leave(1, 0.2);
  EXPECT_FALSE(authority.holder());
  EXPECT_TRUE(authority.obeys(2, 0.3));
}

// At most `burst` at once and `rate` a second over any time.
TEST(RateLimit, BoundsBurstsAndRates) {
  RateLimit limit(100, 20);
  int admitted = 0;
  for (int i = 0; i < 1000; ++i) admitted += limit.admits(5.0) ? 1 : 0;
  EXPECT_EQ(admitted, 20);
  for (int i = 1; i <= 10000; ++i) admitted += limit.admits(5.0 + 1e-4 * i) ? 1 : 0;
  EXPECT_NEAR(admitted, 120, 1);
}

}  // namespace
}  // namespace treeline::drive
