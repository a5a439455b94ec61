// Would catch: a robot that falls through the floor, sinks, creeps or slides farther than friction
// lets it, bounces to another height than restitution says or gains energy; a shape of <collision>
// that touches where it is not; and a start in the ground that goes unnoticed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "program_test.hpp"

namespace treeline {
namespace {

using test::Outcome;

using Columns = std::map<std::string, std::vector<double>>;

Columns read_columns(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::string cell;
  std::vector<std::string> names;
  std::getline(lines, line);
  for (std::istringstream cells(line); std::getline(cells, cell, ',');) names.push_back(cell);
  Columns columns;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    for (std::size_t i = 0; std::getline(cells, cell, ','); ++i) {
      columns[names.at(i)].push_back(std::stod(cell));
    }
  }
  return columns;
}

/// A body of 2 kg that floats, with these collisions.
std::string body(const std::string& collisions) {
  return R"(<robot name="body"><link name="body">
<inertial><mass value="2"/><inertia ixx="0.008" iyy="0.008" izz="0.008" ixy="0" ixz="0" iyz="0"/>
</inertial>)" +
         collisions + "</link></robot>";
}

std::string collision(const std::string& shape, const std::string& rpy = "0 0 0") {
  return "<collision><origin rpy=\"" + rpy + "\"/><geometry>" + shape + "</geometry></collision>";
}

const std::string kBox = "<box size=\"0.4 0.3 0.2\"/>";
const std::string kBall = "<sphere radius=\"0.1\"/>";
constexpr double kGravity = 9.81;

class SimulateOnGround : public test::ProgramTest {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(root_ / name) << text;
  }
  /// The table of a body with this collision on a ground like this.
  [[nodiscard]] Columns simulate(const std::string& shape, const std::string& ground,
                                 const std::string& options) const {
    write("body.urdf", body(shape));
    write("scene.yaml", "base: floating\nground: {" + ground + "}\n");
    const Outcome outcome = run("simulate body.urdf scene.yaml --csv - " + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return read_columns(outcome.out);
  }
};

// Until the last step, in which friction is needed for a part only, the motion is exact.
TEST_F(SimulateOnGround, ABoxSlidesAsFarAsFrictionLets) {
  const auto table = simulate(collision(kBox), "friction: 0.3", "--seconds 1 --qd 1,0,0,0,0,0");
  EXPECT_NEAR(table.at("q0").back(), 1 / (2 * 0.3 * kGravity), 0.3 * kGravity * 1e-6);
  EXPECT_LT(std::abs(table.at("qd0").back()), 1e-9);
  EXPECT_NEAR(table.at("ground_x_N")[100], -0.3 * 2 * kGravity, 1e-6);
  EXPECT_NEAR(table.at("ground_z_N").back(), 2 * kGravity, 1e-6);
  EXPECT_EQ(table.at("contacts").back(), 4);
}

TEST_F(SimulateOnGround, ABoxAtRestKeepsStill) {
  const auto table = simulate(collision(kBox), "", "--seconds 2");
  for (const char* name : {"q0", "q1", "q3", "q4", "q5"}) {
    EXPECT_LT(std::abs(table.at(name).back()), 1e-12) << name;
  }
  EXPECT_NEAR(table.at("q2").back(), 0.1, 1e-12);
}

// A ball that slides at 1 m/s rolls at 5/7 of that when friction has turned it.
TEST_F(SimulateOnGround, ABallRollsAtFiveSeventhsOfItsSpeed) {
  const auto table = simulate(collision(kBall), "friction: 0.3", "--seconds 1 --qd 1,0,0,0,0,0");
  const auto& x = table.at("q0");
  EXPECT_NEAR((x.back() - x[x.size() - 101]) / 0.1, 5.0 / 7, 1e-5);
}

// Rows miss the highest point by at most half a step: g dt^2 / 8.
TEST_F(SimulateOnGround, ABallBouncesToTheHeightsOfItsRestitution) {
  const auto z =
      simulate(collision(kBall), "restitution: 0.8", "--seconds 2.5 --height 1").at("q2");
  double expected = 1;
  int bounces = 0;
  for (std::size_t i = 1; i + 1 < z.size(); ++i) {
    if (!(z[i] > z[i - 1] && z[i] >= z[i + 1])) continue;
    expected *= 0.64;
    ++bounces;
    EXPECT_NEAR(z[i] - 0.1, expected, kGravity * 1e-6 / 8 + 1e-8);
  }
  EXPECT_GE(bounces, 4);
}

TEST_F(SimulateOnGround, ATumblingBoxNeverGainsEnergy) {
  for (const char* ground : {"friction: 0.6", "friction: 0.2, restitution: 0.6"}) {
    const auto energy = simulate(collision(kBox), ground,
                                 "--seconds 3 --height 1 --q 0,0,0,0.3,0.2,0.5,1 "
                                 "--qd 1,2,0,3,4,5")
                            .at("energy_J");
    for (std::size_t i = 1; i < energy.size(); ++i) {
      ASSERT_LE(energy[i] - energy[i - 1], 1e-11 * energy.front()) << i;
    }
    EXPECT_NEAR(energy.back(), 2 * kGravity * 0.1, 1e-4);
  }
}

TEST_F(SimulateOnGround, EveryShapeRestsOnItsSurface) {
  write("wedge.stl",
        "solid wedge\n"
        "facet normal 0 0 -1\nouter loop\nvertex -0.1 -0.1 -0.05\nvertex 0 0.1 -0.05\n"
        "vertex 0.1 -0.1 -0.05\nendloop\nendfacet\n"
        "facet normal 0 1 0\nouter loop\nvertex -0.1 -0.1 -0.05\nvertex 0.1 -0.1 -0.05\n"
        "vertex 0 0 0.1\nendloop\nendfacet\nendsolid wedge\n");
  const std::string quarter = "1.5707963267948966 0 0";
  const std::string rod = "radius=\"0.05\" length=\"0.4\"/>";
  const std::pair<std::string, double> shapes[] = {
      {collision(kBall), 0.1},
      {collision("<cylinder " + rod), 0.2},
      {collision("<cylinder " + rod, quarter), 0.05},
      {collision("<capsule " + rod, quarter), 0.05},
      {collision("<capsule " + rod), 0.25},
      {collision("<mesh filename=\"wedge.stl\"/>"), 0.05},
      {collision("<mesh filename=\"wedge.stl\" scale=\"2 2 2\"/>"), 0.1},
  };
  for (const auto& [shape, height] : shapes) {
    const auto table = simulate(shape, "", "--seconds 0.6 --height 0.1");
    EXPECT_NEAR(table.at("q2").front(), 0.1 + height, 1e-12) << shape;
    EXPECT_NEAR(table.at("q2").back(), height, 1e-6) << shape;
    EXPECT_NEAR(table.at("ground_z_N").back(), 2 * kGravity, 1e-3) << shape;
  }
}

TEST_F(SimulateOnGround, AHumanoidStandsOnItsFeet) {
  const std::string robot = std::string(TREELINE_ROBOTS) + "/humanoid24/";
  write("scene.yaml", "base: floating\nground: {}\n");
  std::string q = "0,0,0,0,0,0,1";
  for (int i = 0; i < 24; ++i) q += ",0";
  const Outcome outcome = run("simulate " + robot + "humanoid24.urdf scene.yaml --q " + q +
                              " --height 0 --stiffness 2000 --damping 20 --seconds 0.5 --csv -");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto table = read_columns(outcome.out);
  EXPECT_NEAR(table.at("q2").back(), table.at("q2").front(), 1e-3);
  EXPECT_NEAR(table.at("q0").back(), 0, 1e-3);
  EXPECT_GE(table.at("contacts").back(), 3);
}

TEST_F(SimulateOnGround, AJointStopsAtItsLimit) {
  write("pendulum.urdf", R"(<robot name="pendulum"><link name="base"/><link name="rod">
<inertial><origin xyz="0 0 -0.5"/><mass value="1"/>
<inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="hinge" type="revolute"><parent link="base"/><child link="rod"/><axis xyz="0 1 0"/>
<limit lower="0.5" upper="2" effort="1" velocity="1"/></joint></robot>)");
  const Outcome outcome = run("simulate pendulum.urdf --stops --q 1 --seconds 2 --csv -");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto table = read_columns(outcome.out);
  EXPECT_NEAR(table.at("q0").back(), 0.5, 1e-9);
  EXPECT_NEAR(table.at("qd0").back(), 0, 1e-9);
  EXPECT_GT(*std::min_element(table.at("q0").begin(), table.at("q0").end()), 0.5 - 1e-5);
  const Outcome beyond = run("simulate pendulum.urdf --stops --q 0.4");
  EXPECT_EQ(beyond.exit_code, 1);
  EXPECT_NE(beyond.err.find("hinge would start at 0.4, beyond its stops at 0.5 and 2"),
            std::string::npos)
      << beyond.err;
}

TEST_F(SimulateOnGround, SaysWhereARobotMayNotStart) {
  write("body.urdf", body(collision(kBox)));
  const Outcome sunk = run("simulate body.urdf --ground --q 0,0,0.05,0,0,0,1");
  EXPECT_EQ(sunk.exit_code, 1);
  EXPECT_NE(sunk.err.find("link body 0.05 m deep"), std::string::npos) << sunk.err;
  EXPECT_NE(sunk.err.find("--height 0"), std::string::npos) << sunk.err;
  const Outcome lifted = run("simulate body.urdf --ground --seconds 0.1");
  EXPECT_EQ(lifted.exit_code, 0);
  EXPECT_NE(lifted.err.find("starts 0.1 m higher"), std::string::npos) << lifted.err;
  const Outcome nowhere = run("simulate body.urdf --height 1");
  EXPECT_EQ(nowhere.exit_code, 1);
  EXPECT_NE(nowhere.err.find("no ground"), std::string::npos) << nowhere.err;
  write("bare.urdf", body(""));
  const Outcome bare = run("simulate bare.urdf --ground");
  EXPECT_EQ(bare.exit_code, 1);
  EXPECT_NE(bare.err.find("no link that moves has a shape"), std::string::npos) << bare.err;
}

TEST_F(SimulateOnGround, CodeHasAStepOrSaysWhyNot) {
  const auto generate = [&](const std::string& shape, const std::string& scene) {
    write("body.urdf", body(shape));
    write("scene.yaml", "base: floating\nfunctions: []\n" + scene);
    return run("generate body.urdf scene.yaml --output code");
  };
  const Outcome bare = generate("", "ground: {step: true}\n");
  EXPECT_EQ(bare.exit_code, 1);
  EXPECT_NE(bare.err.find("no link that moves has a shape"), std::string::npos) << bare.err;
  const std::pair<const char*, const char*> refused[] = {
      {"ground: {step: true, restitution: 0.5}\n", "restitution"},
      {"ground: {step: true}\nprofile: misra\n", "misra"},
      {"ground: {step: true}\ninputs: {gravity: true}\n", "inputs"}};
  for (const auto& [scene, what] : refused) {
    const Outcome outcome = generate(collision(kBox), scene);
    EXPECT_EQ(outcome.exit_code, 1) << scene;
    EXPECT_NE(outcome.err.find(what), std::string::npos) << outcome.err;
  }
  write("implicit.yaml",
        "ground: {step: true}\nfunctions: [forward_dynamics]\n"
        "joint_friction: {model: viscous, implicit: true, joints: {joint1: {damping: 1}}}\n");
  const Outcome implicit =
      run("generate " TREELINE_ROBOTS "/puma560/puma560.urdf implicit.yaml --output code");
  EXPECT_NE(implicit.err.find("(`implicit`)"), std::string::npos) << implicit.err;
  const Outcome made = generate(collision(kBox), "ground: {step: true}\n");
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_TRUE(std::filesystem::exists(root_ / "code" / "body_ground.h"));
  const std::string check = "check body.urdf scene.yaml --generated code --states 1";
  const Outcome compiled = run(check);
  EXPECT_EQ(compiled.exit_code, 0) << compiled.err;
  EXPECT_NE(compiled.err.find("compared with nothing"), std::string::npos) << compiled.err;
  write("code/ground.cpp", "no code");
  const Outcome broken = run(check);
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_NE(broken.err.find("ground.cpp: error: does not compile"), std::string::npos)
      << broken.err;
}

TEST_F(SimulateOnGround, NamesAMeshThatIsMissing) {
  write("body.urdf", body(collision(kBox) + collision("<mesh filename=\"foot.stl\"/>")));
  const Outcome outcome = run("simulate body.urdf --ground --seconds 0.1");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("foot.stl"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("not felt by the ground"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace treeline
