#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "program_test.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::read_file;

const std::string kPuma = TREELINE_ROBOTS "/puma560/puma560.urdf";

using InitSceneTest = test::ProgramTest;

// Would catch: a first command that does not work, or whose result is not reproduced by the command
// in the header. These commands are the README's.
TEST_F(InitSceneTest, AUrdfAloneIsEnough) {
  fs::copy_file(kPuma, root_ / "robot.urdf");
  const Outcome outcome = run("generate robot.urdf --output puma560");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("note: there is no scene"), std::string::npos) << outcome.err;
  const std::string contract = read_file(root_ / "puma560" / "puma560.hpp");
  EXPECT_NE(contract.find("// From robot.urdf, without a scene, by\n"
                          "//   treeline generate robot.urdf --output puma560\n"),
            std::string::npos)
      << contract.substr(0, 300);
  const YAML::Node manifest = YAML::LoadFile(root_ / "puma560" / "manifest.json");
  EXPECT_TRUE(manifest["scene"].IsNull());
  EXPECT_EQ(manifest["inputs"].size(), 1U);
  EXPECT_TRUE(fs::exists(root_ / "puma560" / "forward_dynamics.cpp"));
  EXPECT_FALSE(fs::exists(root_ / "puma560" / "jacobian.cpp"));
  EXPECT_EQ(run("generate robot.urdf --output puma560 --compare").exit_code, 0);
  EXPECT_EQ(run("inspect robot.urdf").exit_code, 0);
  EXPECT_EQ(run("check robot.urdf --functions gravity --states 20").exit_code, 0);
  EXPECT_EQ(run("simulate robot.urdf --seconds 0.1 --svg swing.svg").exit_code, 0);
  EXPECT_EQ(run("init-scene robot.urdf --output scene.yaml").exit_code, 0);
  const Outcome with_scene = run("generate robot.urdf scene.yaml --output other");
  EXPECT_EQ(with_scene.exit_code, 0) << with_scene.err;
  EXPECT_EQ(with_scene.err, "");
  EXPECT_TRUE(fs::exists(root_ / "other" / "control_torque.cpp"));
}

// Would catch: a folder of the user that is overwritten without being asked to.
TEST_F(InitSceneTest, TheDefaultFolderIsNobodyElses) {
  const std::string command = "generate " + kPuma + " --functions gravity";
  EXPECT_EQ(run(command).exit_code, 0);
  EXPECT_TRUE(fs::exists(root_ / "puma560" / "gravity.cpp"));
  EXPECT_EQ(run(command).exit_code, 0);  // its own folder, again
  fs::remove_all(root_ / "puma560");
  fs::create_directories(root_ / "puma560");
  std::ofstream(root_ / "puma560" / "CMakeLists.txt") << "mine";
  const Outcome refused = run(command);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.err.find("--output"), std::string::npos) << refused.err;
  EXPECT_EQ(read_file(root_ / "puma560" / "CMakeLists.txt"), "mine");
}

// Would catch: a refusal that refers to a line of a scene that was never written, or that suggests
// the base which was requested.
TEST_F(InitSceneTest, ABodyThatIsHeldIsRefusedByItsOwnName) {
  const std::string inertial =
      "<inertial><mass value='1'/><inertia ixx='.1' ixy='0' ixz='0' iyy='.2' iyz='0' "
      "izz='.25'/></inertial>";
  const auto write = [&](const char* name, const std::string& inside) {
    std::ofstream(root_ / name) << "<robot name='r'><link name='frame'>" << inside
                                << "</link></robot>";
  };
  write("drone.urdf", inertial);
  write("nothing.urdf", "");
  const Outcome held = run("init-scene drone.urdf --base fixed --output scene.yaml");
  EXPECT_EQ(held.exit_code, 1);
  EXPECT_NE(held.err.find("drone.urdf: error: nothing moves"), std::string::npos) << held.err;
  EXPECT_NE(held.err.find("leave out --base fixed"), std::string::npos) << held.err;
  EXPECT_EQ(held.err.find("scene.yaml"), std::string::npos) << held.err;
  EXPECT_FALSE(fs::exists(root_ / "scene.yaml"));
  const Outcome empty = run("init-scene nothing.urdf");
  EXPECT_EQ(empty.exit_code, 1);
  EXPECT_NE(empty.err.find("give its links mass"), std::string::npos) << empty.err;
}

// Would catch: a drone that is refused because it has no joints, or whose base differs from the
// message.
TEST_F(InitSceneTest, AFreeBodyFloats) {
  std::ofstream(root_ / "drone.urdf")
      << "<robot name='drone'><link name='frame'><inertial><mass value='1'/><inertia ixx='.1' "
         "ixy='0' ixz='0' iyy='.2' iyz='0' izz='.25'/></inertial></link></robot>";
  const Outcome outcome = run("generate drone.urdf");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("the base floats, for no joint moves"), std::string::npos);
  EXPECT_NE(read_file(root_ / "drone" / "drone.hpp").find("floating base"), std::string::npos);
  EXPECT_NE(run("inspect drone.urdf").out.find("floating"), std::string::npos);
  const Outcome scene = run("init-scene drone.urdf -o scene.yaml");
  ASSERT_EQ(scene.exit_code, 0) << scene.err;
  const YAML::Node read = YAML::LoadFile(root_ / "scene.yaml");
  EXPECT_EQ(read["base"].as<std::string>(), "floating");
  EXPECT_EQ(read["operational_points"][0]["rows"].size(), 6U);
}

TEST_F(InitSceneTest, OverwritesNothing) {
  std::ofstream(root_ / "scene.yaml") << "mine";
  const Outcome refused = run("init-scene " + kPuma + " -o scene.yaml");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.err.find("--force"), std::string::npos) << refused.err;
  EXPECT_EQ(read_file(root_ / "scene.yaml"), "mine");
  EXPECT_EQ(run("init-scene " + kPuma + " -o scene.yaml --force").exit_code, 0);
  EXPECT_EQ(YAML::LoadFile(root_ / "scene.yaml")["name"].as<std::string>(), "puma560");
  EXPECT_EQ(run("init-scene nowhere.urdf").exit_code, 1);
  EXPECT_EQ(run("init-scene " + kPuma + " --base sideways").exit_code, 2);
}

// Would catch: a foot that is a ball whose radius is lost between the file and the proposal.
TEST_F(InitSceneTest, FeetTouchUnderTheirBalls) {
  const Outcome outcome = run("init-scene " TREELINE_ROBOTS "/tumbler/tumbler.urdf");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("contact: point, origin: {xyz: [0, -0.00887, -0.20866]}"),
            std::string::npos)
      << outcome.out;
}

}  // namespace
}  // namespace treeline
