// Would catch: files of strangers of which Treeline says something false, or something else than
// what is wrong.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "program_test.hpp"

namespace treeline {
namespace {

using test::Outcome;

/// An arm of one joint.
std::string arm(const std::string& limits, const std::string& inertial, const char* tip = "tip") {
  const std::string named = "\"" + std::string(tip) + "\"";
  return "<robot name=\"arm\"><link name=\"base\"/>\n"
         "<joint name=\"turn\" type=\"revolute\"><parent link=\"base\"/><child link=" +
         named + "/><axis xyz=\"0 1 0\"/><limit lower=\"-1\" upper=\"1\" " + limits +
         "/></joint>\n<link name=" + named + ">" + inertial + "</link></robot>\n";
}

std::string inertial(const std::string& ixx) {
  return "<inertial><origin xyz=\"0.2 0 0\"/><mass value=\"1\"/><inertia ixx=\"" + ixx +
         "\" ixy=\"0\" ixz=\"0\" iyy=\"0.01\" iyz=\"0\" izz=\"0.01\"/></inertial>";
}

const std::string kLimits = R"(effort="10" velocity="2")";

class OddNumbersTest : public test::ProgramTest {
 protected:
  [[nodiscard]] Outcome run_to(const std::string& arguments, int exit_code) const {
    Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << arguments << "\n" << outcome.err;
    return outcome;
  }
};

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(OddNumbersTest, TheLargestNumberIsNoLimit) {
  for (const char* name : {"effort", "velocity"}) {
    const std::string other = name == std::string("effort") ? "velocity" : "effort";
    write("arm.urdf", arm(std::string(name) + "=\"1.7976931348623157e+308\" " + other + "=\"2\"",
                          inertial("0.01")));
    const Outcome outcome = run_to("generate arm.urdf -o out --warnings all", 0);
    EXPECT_TRUE(holds(outcome.err, "more than anything reaches")) << outcome.err;
    const std::string header = test::read_file(root_ / "out/arm.hpp");
    EXPECT_TRUE(holds(header, "Rounding: at most")) << header;
    EXPECT_FALSE(holds(header, "Rounding: none") || holds(header, "nan ulp")) << header;
  }
}

TEST_F(OddNumbersTest, NoSpeedAndNoForceAreToldAndAreNoLimits) {
  write("arm.urdf", arm(R"(effort="0" velocity="0")", inertial("0.01")));
  const Outcome outcome = run_to("generate arm.urdf -o out", 0);
  EXPECT_TRUE(holds(outcome.err,
                    "velocity=0: a placeholder that counts as no limit; bounds of "
                    "rounding errors take 10 rad/s"))
      << outcome.err;
  EXPECT_TRUE(holds(outcome.err,
                    "effort=0: a placeholder that counts as no limit; bounds of "
                    "rounding errors take 1000 N m"))
      << outcome.err;
  const std::string header = test::read_file(root_ / "out/arm.hpp");
  EXPECT_TRUE(holds(header, "-1 .. 1 rad, no limit of effort (0 in the file)")) << header;
  const std::string joints = test::read_file(root_ / "out/arm_joints.hpp");
  for (const char* limit :
       {"kVelocityLimits[1] = {\n    kUnlimited", "kEffortLimits[1] = {\n    kUnlimited"}) {
    EXPECT_TRUE(holds(joints, limit)) << limit << joints;
  }
}

TEST_F(OddNumbersTest, AControllerWithoutTorqueIsRefusedOrWaivesTheLimit) {
  write("arm.urdf", arm(R"(effort="0" velocity="2")", inertial("0.01")));
  write("bare.yaml", "controller: {laws: joint_impedance}\n");
  const Outcome refused = run_to("generate arm.urdf bare.yaml -o out", 1);
  EXPECT_TRUE(holds(refused.err, "no limit of torque of \"turn\" (effort=0 is a placeholder)"))
      << refused.err;
  write("waived.yaml", "controller: {laws: joint_impedance, limits: {turn: {torque: none}}}\n");
  const Outcome waived = run_to("generate arm.urdf waived.yaml -o out", 0);
  EXPECT_TRUE(holds(waived.err, "the controller has what the scene says")) << waived.err;
}

TEST_F(OddNumbersTest, NoBoundIsOfSpeedsThatNothingReaches) {
  for (const auto& [velocity, reach] : {std::pair{"1e8", "10"}, {"5000", "100"}}) {
    write("arm.urdf",
          arm(std::string("effort=\"10\" velocity=\"") + velocity + "\"", inertial("0.01")));
    const Outcome outcome = run_to("generate arm.urdf -o out --functions inverse_dynamics", 0);
    EXPECT_TRUE(holds(outcome.err, std::string("bounds of rounding errors"))) << outcome.err;
    const std::string header = test::read_file(root_ / "out/arm.hpp");
    EXPECT_TRUE(holds(header, std::string("|qd| <= ") + reach + ",")) << header;
  }
}

TEST_F(OddNumbersTest, FollowersLimitTheirLeader) {
  std::string text = arm(R"(effort="10" velocity="5")", inertial("0.01"));
  text.replace(text.find("</robot>"), 8,
               "<link name=\"jaw\">" + inertial("0.01") +
                   "</link><joint name=\"follow\" type=\"revolute\"><parent link=\"tip\"/><child "
                   "link=\"jaw\"/><axis xyz=\"0 1 0\"/><limit lower=\"-0.5\" upper=\"0.5\" "
                   "effort=\"1\" velocity=\"1\"/><mimic joint=\"turn\" multiplier=\"-2\" "
                   "offset=\"0.1\"/></joint></robot>");
  write("arm.urdf", text);
  const Outcome outcome = run_to("generate arm.urdf -o out --functions gravity", 0);
  EXPECT_TRUE(holds(outcome.err, "from -0.2 to 0.3, up to 0.5 a second")) << outcome.err;
  const std::string header = test::read_file(root_ / "out/arm.hpp");
  EXPECT_TRUE(holds(header, "-0.2 .. 0.3 rad, 10 N m, 0.5 rad/s")) << header;
}

TEST_F(OddNumbersTest, SimulateSaysWhatHasNoInertia) {
  write("arm.urdf", arm(kLimits, ""));
  const Outcome outcome = run_to("simulate arm.urdf", 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(holds(outcome.err, "no inertia resists joint \"turn\"")) << outcome.err;
  EXPECT_TRUE(holds(outcome.err, "Give link \"tip\" mass")) << outcome.err;
}

TEST_F(OddNumbersTest, SimulateTellsOfQuaternionsThatThereAre) {
  write("arm.urdf", arm(kLimits, inertial("0.01")));
  EXPECT_FALSE(holds(run_to("simulate arm.urdf --seconds 0.01", 0).out, "quaternions"));
  write("ship.urdf",
        "<robot name=\"ship\"><link name=\"hull\">" + inertial("0.01") + "</link></robot>\n");
  write("free.yaml", "base: floating\n");
  EXPECT_TRUE(holds(run_to("simulate ship.urdf free.yaml --seconds 0.01", 0).out, "quaternions"));
}

TEST_F(OddNumbersTest, ARobotsFileIsNoScene) {
  write("arm.urdf", arm(kLimits, inertial("0.01")));
  const Outcome outcome = run_to("generate arm.urdf arm.urdf -o out", 1);
  EXPECT_TRUE(holds(outcome.err, "this is XML")) << outcome.err;
  EXPECT_LT(outcome.err.size(), 300U) << outcome.err;
  write("long.yaml", "base: [" + std::string(5000, 'x') + "]\nlocked: " + std::string(5000, 'y'));
  EXPECT_LT(run_to("inspect arm.urdf long.yaml", 1).err.size(), 1000U);
}

TEST_F(OddNumbersTest, APartOfAXacroIsOneFault) {
  write(
      "leg.xacro",
      "<robot>\n<xacro:macro name=\"leg\"><link name=\"${side}_leg\"/></xacro:macro>\n</robot>\n");
  const Outcome outcome = run_to("inspect leg.xacro", 1);
  EXPECT_TRUE(holds(outcome.err, "this is xacro text")) << outcome.err;
  EXPECT_TRUE(holds(outcome.err, "the file that includes it")) << outcome.err;
  EXPECT_FALSE(holds(outcome.err, "no <link>")) << outcome.err;
}

TEST_F(OddNumbersTest, ProposedScenesQuoteWhatIsNothingInYaml) {
  write("arm.urdf", arm(kLimits, inertial("0.01"), "null"));
  (void)run_to("init-scene arm.urdf --output scene.yaml", 0);
  (void)run_to("inspect arm.urdf scene.yaml", 0);
}

TEST_F(OddNumbersTest, InertiasOfOneFaultAreOneLine) {
  std::string text = arm(kLimits, inertial("0.5"));
  const std::string end = "</robot>";
  text.replace(
      text.find(end), end.size(),
      "<link name=\"lid\">" + inertial("0.6") +
          "</link><joint name=\"hinge\" "
          "type=\"revolute\"><parent link=\"tip\"/><child link=\"lid\"/><limit lower=\"-1\" "
          "upper=\"1\" " +
          kLimits + "/></joint></robot>");
  write("arm.urdf", text);
  const std::string told = run_to("inspect arm.urdf", 0).err;
  const auto first = told.find("no body has this inertia");
  ASSERT_NE(first, told.npos) << told;
  EXPECT_EQ(told.find("no body has this inertia", first + 1), told.npos) << told;
  EXPECT_TRUE(holds(told, "so it is with \"lid\"")) << told;
}

TEST_F(OddNumbersTest, DustOfRoundingIsNoInertia) {
  write("arm.urdf", arm(kLimits,
                        "<inertial><origin xyz=\"0.2 0 0\"/><mass value=\"1\"/><inertia "
                        "ixx=\"0\" ixy=\"0\" ixz=\"2.4e-35\" iyy=\"0\" iyz=\"0\" "
                        "izz=\"0\"/></inertial>"));
  EXPECT_FALSE(holds(run_to("inspect arm.urdf", 0).err, "indefinite"));
}

TEST_F(OddNumbersTest, TheSmallestMomentsAreNone) {
  write("arm.urdf",
        arm(kLimits,
            "<inertial><origin xyz=\"0.2 0 0\"/><mass value=\"1\"/><inertia ixx=\"1e-310\" "
            "ixy=\"0\" ixz=\"0\" iyy=\"1e-310\" iyz=\"0\" "
            "izz=\"1e-310\"/></inertial>"));
  const std::string told = run_to("generate arm.urdf -o out", 0).err;
  EXPECT_TRUE(holds(told, "moments of inertia, at most 1e-310 kg m^2, are too small")) << told;
}

TEST_F(OddNumbersTest, ALinkAloneNeedsMassToMove) {
  write("box.urdf", "<robot name=\"box\"><link name=\"box\"/></robot>\n");
  const std::string told = run_to("generate box.urdf -o out", 1).err;
  EXPECT_TRUE(holds(told, "give its links mass")) << told;
}

}  // namespace
}  // namespace treeline
