// Would catch: a name of this machine that another site can take, an address of its own that is
// refused where others may connect, and tokens that repeat.
#include <gtest/gtest.h>

#include "drive/server.hpp"

namespace treeline::drive {
namespace {

TEST(OwnHost, AcceptsNumbersWhereOthersMayConnect) {
  EXPECT_TRUE(is_own_host("10.1.2.3:80", "0.0.0.0", 80));
  EXPECT_TRUE(is_own_host("[fe80::1]:80", "::", 80));
  EXPECT_FALSE(is_own_host("robot.example:80", "0.0.0.0", 80));
  EXPECT_FALSE(is_own_host("10.1.2.3:80", "127.0.0.1", 80));
  EXPECT_NE(make_token(), make_token());
}

}  // namespace
}  // namespace treeline::drive
