#include "mechanism/find_limbs.hpp"

#include <gtest/gtest.h>

// Would catch: limbs that are not isomorphic in one family, limbs within limbs that are listed
// twice, and links that do not correspond.
namespace treeline {
namespace {

/// A tree of links given by their parents, with revolute joints by default.
Mechanism tree(const std::vector<int>& parents) {
  Mechanism mechanism;
  for (const int parent : parents) {
    MovingLink link;
    link.parent = parent;
    mechanism.links.push_back(link);
  }
  return mechanism;
}

using Limbs = std::vector<std::vector<int>>;

TEST(FindLimbs, ArmsOfATorso) {
  //           torso, arm, hand, finger x2, the other arm, hand, finger x2, head
  const auto families = find_limbs(tree({-1, 0, 1, 2, 2, 0, 5, 6, 6, 0}), 8);
  ASSERT_EQ(families.size(), 1u);
  EXPECT_EQ(families[0].limbs, (Limbs{{1, 2, 3, 4}, {5, 6, 7, 8}}));
}

TEST(FindLimbs, EveryLimbOfAFamilyOnce) {
  const auto families = find_limbs(tree({-1, 0, 1, 0, 3, 0, 5, 0, 7}), 8);
  ASSERT_EQ(families.size(), 1u);
  EXPECT_EQ(families[0].limbs, (Limbs{{1, 2}, {3, 4}, {5, 6}, {7, 8}}));
}

TEST(FindLimbs, UnlikeLimbsAreSearchedForLimbs) {
  Mechanism mechanism = tree({-1, 0, 1, 1, 0, 4});
  mechanism.links[5].kind = JointKind::prismatic;
  const auto families = find_limbs(mechanism, 8);
  ASSERT_EQ(families.size(), 1u);
  EXPECT_EQ(families[0].limbs, (Limbs{{2}, {3}}));
}

TEST(FindLimbs, RobotsThatShareAWorld) {
  const auto families = find_limbs(tree({-1, 0, -1, 2}), 8);
  ASSERT_EQ(families.size(), 1u);
  EXPECT_EQ(families[0].limbs, (Limbs{{0, 1}, {2, 3}}));
}

TEST(FindLimbs, NoMoreThanThereAreLanes) {
  EXPECT_TRUE(find_limbs(tree({-1, 0, 0, 0}), 2).empty());
  EXPECT_TRUE(find_limbs(tree({-1, 0}), 8).empty());
  EXPECT_TRUE(find_limbs(tree({-1, 0, 0}), 1).empty());
}

}  // namespace
}  // namespace treeline
