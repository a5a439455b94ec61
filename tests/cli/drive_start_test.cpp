// Would catch: a start that `drive` chooses with a hand in a thigh, or with a robot that floats
// knee deep below the ground.
#include "drive_fixture.hpp"
#include "overlaps/find_overlaps.hpp"

namespace treeline {
namespace {

class DriveStartTest : public DriveTest {};

/// Judged by FCL. The first state is that of the start.
TEST_F(DriveStartTest, NoLinkIsInAnother) {
  for (const std::string& name : {"humanoid24", "puma560", "ur10e", "samm"}) {
    const std::string folder = kRobots + "/" + name + "/";
    const Outcome outcome = drive(folder + name + ".urdf " + folder + "scene.yaml",
                                  "start\nwait 0.05 s\n", "--record start.jsonl");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    experiments::OverlapQuestion question;
    question.robot = folder + name + ".urdf";
    question.scene = folder + "scene.yaml";
    question.motion = (root_ / "start.jsonl").string();
    question.floor = false;  // a base that stands on it touches it
    if (name == "humanoid24") {
      question.left_out = experiments::read_left_out(folder + "may_overlap.txt");
    }
    Diagnostics diagnostics;
    const auto overlaps = experiments::find_overlaps(question, diagnostics);
    ASSERT_TRUE(overlaps.has_value());
    for (const experiments::Overlap& overlap : *overlaps) {
      EXPECT_LT(overlap.depth, 1e-3) << name << ": " << overlap.first << " in " << overlap.second;
    }
  }
}

/// A body whose one leg ends in a ball of 5 cm, 0.8 m below the hip, which is 0.1 m below the base.
/// Whatever the base's height is in the file, it stands on the ball. `--q` is taken as it is.
TEST_F(DriveStartTest, AFloatingRobotStandsOnTheGround) {
  write("leg.urdf", R"(<robot name="leg">
  <link name="body">
    <inertial><mass value="5"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><geometry><box size="0.2 0.2 0.2"/></geometry></collision>
  </link>
  <link name="shin">
    <inertial><origin xyz="0 0 -0.4"/><mass value="1"/>
      <inertia ixx="0.1" iyy="0.1" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><origin xyz="0 0 -0.8"/><geometry><sphere radius="0.05"/></geometry></collision>
  </link>
  <joint name="hip" type="revolute"><parent link="body"/><child link="shin"/>
    <origin xyz="0 0 -0.1"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="100" velocity="5"/></joint>
</robot>)");
  write("scene.yaml", "base: floating\n");
  const auto height = [&](const std::string& options) {
    const Outcome outcome = drive("leg.urdf scene.yaml", "start\nwait 0.05 s\n", options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out)["q"][2].get<double>();
  };
  EXPECT_NEAR(height(""), 0.95, 1e-6);
  EXPECT_NEAR(height("--q 0,0,0.3,0,0,0,1,0"), 0.3, 1e-6);
}

}  // namespace
}  // namespace treeline
