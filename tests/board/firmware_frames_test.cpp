// `treeline generate --package firmware` on this machine: frames between it and drives and a front
// end that read them as can.h says (firmware_port.c), of a wheel that has turned far and a lift
// whose weight is more than 2147 N. Would catch: quantities that wrap or are cut in a frame,
// numbers that are none which move a robot, a step that frames without end hold up, and a status
// that is read while it changes.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include "check/fixture.hpp"
#include "cli/run_program.hpp"

namespace treeline::tests {
namespace {

const char* const kRobot = R"(<robot name="box">
  <link name="base"/>
  <link name="wheel"><inertial><mass value="1"/>
    <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="lift"><inertial><mass value="1000"/>
    <inertia ixx="9" iyy="9" izz="9" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="turn" type="continuous"><parent link="base"/><child link="wheel"/>
    <axis xyz="0 0 1"/><limit effort="50" velocity="10"/></joint>
  <joint name="raise" type="prismatic"><parent link="base"/><child link="lift"/>
    <axis xyz="0 0 1"/><limit effort="30000" velocity="1" lower="0" upper="1"/></joint>
</robot>)";

constexpr double kWeight = 1000 * 9.81;

/// Numbers that firmware_port.c printed, by name.
using Log = std::map<std::string, double>;

class FirmwareFrames : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    write_file(folder_.path() / "box.urdf", kRobot);
    write_file(folder_.path() / "scene.yaml",
               std::string("name: box\nlanguage: c\ntarget: cortex-m7\nfunctions: "
                           "[forward_dynamics]\ncontroller: {laws: [joint_impedance]}\nreal: ") +
                   GetParam());
    const test::Outcome made = test::run_program(
        folder_.path(),
        "generate box.urdf scene.yaml --package firmware --warnings none --output firmware");
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const std::string compiler = std::string("'" TREELINE_CC "' ") + "-std=gnu99 -O1 -I. -Isrc ";
    ASSERT_EQ(run(compiler + "-Dmain=firmware_main -c main.c && " + compiler +
                  "-Wl,--wrap=can_write_status main.o can.c '" TREELINE_BOARD_TESTS
                  "/firmware_port.c' $(ls src/*.c) -lm -o program"),
              0)
        << output();
  }

  int run(const std::string& command) {
    const std::string in_folder =
        "cd '" + (folder_.path() / "firmware").string() + "' && (" + command + ") >log.txt 2>&1";
    return std::system(in_folder.c_str());
  }

  std::string output() { return read_file(folder_.path() / "firmware" / "log.txt"); }

  Log let_happen(const std::string& event) {
    EXPECT_EQ(run("timeout 60 ./program '" + event + "'"), 0) << event << ":\n" << output();
    EXPECT_EQ(output().find("not a torque"), std::string::npos) << event << ":\n" << output();
    Log log;
    std::istringstream lines(output());
    for (std::string line; std::getline(lines, line);) {
      const std::size_t space = line.rfind(' ');
      log[line.substr(0, space)] = std::strtod(line.c_str() + space, nullptr);
    }
    return log;
  }

  TemporaryFolder folder_;
};

TEST_P(FirmwareFrames, CarryWhatTheRobotReaches) {
  const Log log = let_happen("nothing");
  EXPECT_EQ(log.at("mode"), 1) << output();
  EXPECT_EQ(log.at("faults"), 0) << output();
  EXPECT_EQ(log.at("refused"), 0) << output();
  EXPECT_NEAR(log.at("lift"), kWeight, 1e-6 * kWeight) << output();
  EXPECT_GT(std::abs(log.at("wheel")), 1) << "it should be led away from where it is kept";
  EXPECT_EQ(log.at("torn"), 0) << "the status changed while it was read";
  EXPECT_EQ(log.at("frames a step"), 2) << output();
  // More than the 65 s of 16 bits in ms; nothing moves fast, and nothing is refused.
  EXPECT_EQ(let_happen("long").at("refused"), 0) << output();
}

TEST_P(FirmwareFrames, WhichAreNoNumbersMoveNothing) {
  for (const char* event : {"nan", "infinite"}) {
    const Log log = let_happen(event);
    EXPECT_EQ(log.at("mode"), 3) << event << ":\n" << output();
    EXPECT_EQ(std::lround(log.at("faults")) & 1, 1) << event << ":\n" << output();
    EXPECT_EQ(log.at("brake"), 1) << event << ":\n" << output();
  }
  const Log far = let_happen("far");  // a jump: finite, and farther than any joint comes
  EXPECT_EQ(far.at("mode"), 3) << output();
  EXPECT_EQ(far.at("brake"), 1) << output();
  EXPECT_EQ(let_happen("no duration").at("refused"), 4) << output();
  EXPECT_EQ(let_happen("no goal").at("refused"), 5) << output();
  EXPECT_EQ(let_happen("far goal").at("refused"), 5) << output();
}

TEST_P(FirmwareFrames, WithoutEndEndInBrakes) {
  const Log log = let_happen("flood");
  EXPECT_EQ(log.at("frames a step"), 8) << output();
  EXPECT_EQ(log.at("mode"), 3) << output();
  EXPECT_EQ(log.at("brake"), 1) << output();
}

INSTANTIATE_TEST_SUITE_P(Of, FirmwareFrames, testing::Values("float", "double"));

}  // namespace
}  // namespace treeline::tests
