#include "overlaps/find_overlaps.hpp"

#include <gtest/gtest.h>

#include "../own_folder.hpp"

// A robot of balls on slides, whose depths in each other and in the ground are known. Would catch:
// a pair that is not looked at, one that is left out and should not be, a shape at another place,
// and a depth or time of another moment.

namespace treeline::experiments {
namespace {

constexpr const char* kSlides = R"(<robot name="slides">
<link name="base"><collision><origin xyz="0 0 0.5"/><geometry><box size="0.2 0.2 0.2"/></geometry></collision></link>
<link name="left_arm"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><geometry><sphere radius="0.05"/></geometry></collision></link>
<link name="left_hand"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><origin xyz="0 0.3 0"/><geometry><sphere radius="0.1"/></geometry></collision></link>
<joint name="x" type="prismatic"><parent link="base"/><child link="left_arm"/><origin xyz="0 0 0.5"/>
  <axis xyz="1 0 0"/><limit lower="-2" upper="2" effort="9" velocity="9"/></joint>
<joint name="y" type="prismatic"><parent link="left_arm"/><child link="left_hand"/>
  <axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="9" velocity="9"/></joint>
</robot>)";

class FindOverlaps : public test::OwnFolder {
 protected:
  /// What is found in a motion, the lines of a table of time, q_x and q_y.
  std::vector<Overlap> find(const std::string& motion, std::vector<std::string> left_out = {}) {
    write("slides.urdf", kSlides);
    write("motion.csv", "time,q_x,q_y\n" + motion);
    OverlapQuestion question;
    question.robot = (root_ / "slides.urdf").string();
    question.motion = (root_ / "motion.csv").string();
    question.left_out = std::move(left_out);
    Diagnostics diagnostics;
    const auto overlaps = find_overlaps(question, diagnostics);
    EXPECT_TRUE(overlaps) << (diagnostics.list().empty() ? "" : to_string(diagnostics.list()[0]));
    return overlaps.value_or(std::vector<Overlap>{});
  }
};

// The base's side is at y = 0.1, the hand's ball begins at y = 0.2 + q_y: 2 cm inside at q_y =
// -0.12.
TEST_F(FindOverlaps, SaysHowDeepAndWhen) {
  const auto found = find("0,0,0\n0.1,0,-0.05\n0.2,0,-0.12\n0.3,0,-0.11\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].first + found[0].second, "baseleft_hand");
  EXPECT_NEAR(found[0].depth, 0.02, 1e-6);  // FCL iterates
  EXPECT_EQ(found[0].time, 0.2);
}

TEST_F(FindOverlaps, LeavesOutNeighboursAndWhatItIsTold) {
  EXPECT_TRUE(find("0,0,0\n").empty());  // the arm's ball is in the base, beside a joint
  EXPECT_TRUE(find("0,0,-0.12\n", {"base:left_hand"}).empty());
  EXPECT_FALSE(find("0,0,-0.12\n", {"base:hand"}).empty());  // they do not begin alike
}

TEST_F(FindOverlaps, LooksAtTheGround) {
  std::string lower = kSlides;
  write("low.urdf", lower.replace(lower.find("<origin xyz=\"0 0 0.5\"/>\n  <axis"), 23,
                                  "<origin xyz=\"1 0 0.07\"/>"));
  write("motion.csv", "time,q_x,q_y\n0,0,0\n");
  OverlapQuestion question;
  question.robot = (root_ / "low.urdf").string();
  question.motion = (root_ / "motion.csv").string();
  Diagnostics diagnostics;
  const auto found = find_overlaps(question, diagnostics);
  ASSERT_TRUE(found && found->size() == 1);
  EXPECT_EQ(found->front().second, "floor");
  EXPECT_NEAR(found->front().depth, 0.03, 1e-9);
  question.floor = false;
  EXPECT_TRUE(find_overlaps(question, diagnostics)->empty());
}

}  // namespace
}  // namespace treeline::experiments
