// Would catch: a robot of a kind that few are of, taken for an arm, a dog of eight legs or a hand.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "inspect/scene_proposals.hpp"

namespace treeline {
namespace {

using test::list_points, test::read, test::robot_text;

/// A link of 0.1 kg with its joint.
std::string part(const std::string& parent, const std::string& name, const std::string& origin,
                 const std::string& axis, const std::string& type = "continuous") {
  return "<link name='" + name +
         "'><inertial><origin xyz='0 0 -.02'/><mass value='.1'/><inertia ixx='.01' ixy='0' ixz='0' "
         "iyy='.01' iyz='0' izz='.01'/></inertial></link><joint name='" +
         name + "_joint' type='" + type + "'><origin xyz='" + origin + "'/><parent link='" +
         parent + "'/><child link='" + name + "'/><axis xyz='" + axis +
         "'/><limit lower='0' upper='1' effort='9' velocity='9'/></joint>";
}

/// So many links in a row.
std::string chain(const std::string& parent, const std::vector<std::string>& names,
                  const std::string& first, const std::string& step) {
  std::string text, before = parent;
  for (const std::string& name : names) {
    text += part(before, name, before == parent ? first : step, "0 1 0");
    before = name;
  }
  return text;
}

SceneProposal propose(const std::string& root, const std::string& inside) {
  return propose_scene(read(robot_text(root, inside)), std::nullopt);
}

// Would catch: "hand" in all names taken for arms, and a thumb on a metacarpus for an arm.
TEST(NameKind, TellsAHandWhoseLinksAllSaySo) {
  const std::string fingers =
      chain("palm", {"l_hand_index_1", "l_hand_index_2"}, "0 .03 0", "0 0 -.04") +
      chain("palm", {"l_hand_medium_1", "l_hand_medium_2"}, "0 0 0", "0 0 -.04") +
      chain("palm", {"l_hand_meta", "l_hand_thumb_1", "l_hand_thumb_2", "l_hand_thumb_3"},
            "0 -.03 0", "0 0 -.03");
  const SceneProposal hand = propose("palm", fingers);
  EXPECT_EQ(hand.kind, "a hand");
  EXPECT_EQ(hand.base, Base::fixed);
  ASSERT_EQ(hand.points.size(), 3U) << list_points(hand);
  EXPECT_EQ(hand.points[2].link, "l_hand_thumb_3");
}

// Would catch: "foot" in all names taken for legs.
TEST(NameKind, TellsAFootWhoseLinksAllSaySo) {
  std::string chains;
  for (const std::string side : {"left", "right"}) {
    const std::string name = "softfoot_" + side;
    chains += chain("ankle", {name + "_1", name + "_2", name + "_tip_link"}, "0 0 -.1", ".03 0 0");
  }
  const SceneProposal foot = propose("ankle", chains);
  EXPECT_EQ(foot.kind, "a foot");
  EXPECT_EQ(foot.base, Base::fixed);
}

// Would catch: a quadruped whose legs are five-bars counted by its motors, with two points a leg.
TEST(NameKind, CountsTheHalvesOfALegOnce) {
  std::string legs;
  for (const std::string side : {"-", ""}) {
    for (const std::string x : {"-.2", ".2"}) {
      for (const std::string y : {".10", ".16"}) {
        const std::string name = "leg" + y + side + "_" + x;
        legs += chain("trunk", {name + "_motor", name + "_shank"}, x + " " + side + y + " 0",
                      "0 0 -.1");
      }
    }
  }
  const SceneProposal dog = propose("trunk", legs);
  EXPECT_EQ(dog.kind, "a quadruped");
  EXPECT_EQ(dog.base, Base::floating);
  EXPECT_EQ(dog.points.size(), 4U) << list_points(dog);
}

// Would catch: eight whole legs in a row on each side counted as four.
TEST(NameKind, CountsEightLegsApart) {
  std::string legs;
  for (const std::string side : {"-", ""}) {
    for (const std::string x : {"-.3", "-.1", ".1", ".3"}) {
      const std::string name = "leg" + side + "_" + x;
      legs += chain("trunk", {name + "_hip", name + "_shank"}, x + " " + side + ".15 0", "0 0 -.1");
    }
  }
  EXPECT_EQ(propose("trunk", legs).kind, "a robot of 8 legs");
}

// Would catch: nameless legs below a waist taken for arms.
TEST(NameKind, FindsLegsBelowAWaist) {
  std::string limbs = part("torso", "hip", "0 0 -.1", "0 0 1");
  for (const std::string side : {"-", ""}) {
    limbs += chain("hip", {"a" + side, "b" + side, "c" + side}, "0 " + side + ".1 0", "0 0 -.3") +
             chain("torso", {"d" + side, "e" + side, "f" + side}, "0 " + side + ".2 .3", ".2 0 0");
  }
  const SceneProposal humanoid = propose("torso", limbs);
  EXPECT_EQ(humanoid.kind, "a humanoid");
  EXPECT_EQ(humanoid.base, Base::floating);
}

// Would catch: points on sonars and fins of a vehicle, and one that steers by them held.
TEST(NameKind, LetsFloatWhatHasFins) {
  std::string parts = part("hull", "dvl_sonar", "0 0 -.1", "0 0 1");
  for (const std::string at : {"-.2", ".1", ".2"}) {
    parts += part("hull", "fin" + at, at + " 0 0", "0 1 0");
  }
  const SceneProposal vehicle = propose("hull", parts);
  EXPECT_EQ(vehicle.kind, "a flying or swimming robot");
  EXPECT_EQ(vehicle.base, Base::floating);
  EXPECT_EQ(list_points(vehicle), "hull: x y z rx ry rz ; ");
}

// Would catch: a handle taken for a hand, and drawers for fingers.
TEST(NameKind, TellsFurniture) {
  const std::string parts = part("kitchen", "sink_drawer", "0 0 0", "1 0 0", "prismatic") +
                            part("sink_drawer", "sink_drawer_handle", ".1 0 0", "", "fixed") +
                            part("kitchen", "oven_door", "0 1 0", "0 1 0", "revolute");
  const SceneProposal kitchen = propose("kitchen", parts);
  EXPECT_EQ(kitchen.kind, "a piece of furniture");
  EXPECT_EQ(kitchen.base, Base::fixed);
  EXPECT_EQ(kitchen.points.size(), 2U) << list_points(kitchen);
}

// Would catch: one body that moves in a plane, as a ball beside an arm, counted as an arm or given
// a point; and one leg on a stand called a mechanism.
TEST(NameKind, CountsNoArmOfOneBodyAndOneLeg) {
  const std::string ball =
      "<link name='x'/><joint name='jx' type='prismatic'><parent link='stand'/><child link='x'/>"
      "<axis xyz='1 0 0'/><limit lower='0' upper='1' effort='1' velocity='1'/></joint>"
      "<link name='z'/><joint name='jz' type='prismatic'><parent link='x'/><child link='z'/>"
      "<axis xyz='0 0 1'/><limit lower='0' upper='1' effort='1' velocity='1'/></joint>" +
      part("z", "ball", "0 0 0", "0 1 0");
  EXPECT_EQ(propose("stand", ball).kind, "a mechanism");
  const std::string arm = chain("stand", {"a", "b", "c", "d"}, "0 0 1", "0 0 .3");
  const SceneProposal beside = propose("stand", arm + ball);
  EXPECT_EQ(beside.kind, "an arm");
  ASSERT_EQ(beside.points.size(), 1U) << list_points(beside);
  EXPECT_EQ(beside.points[0].link, "d");
  EXPECT_EQ(propose("stand", chain("stand", {"hip", "knee", "foot"}, "0 0 1", "0 0 -.3")).kind,
            "a leg");
}

}  // namespace
}  // namespace treeline
