#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "bench/bench.hpp"
#include "bench/draw_svg.hpp"
#include "compilation/temporary_folder.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"

// A module whose results are known is loaded and measured. Would catch: a peer that gets another
// one's time or error, a peer that is listed although it computes something else, a call into a
// module of another version, a limitation of a peer that is not reported, a function that it is not
// asked for, and rows held on another link.

namespace treeline::tests {
namespace {

// Inertia about the joint 3 * 0.5^2 + 1.25 = 2 kg m^2, first moment 3 * 0.5 = 1.5 kg m.
constexpr const char* kPendulum = R"(<robot name="pendulum">
  <link name="base"/>
  <link name="arm">
    <inertial>
      <origin xyz="0 0 -0.5"/><mass value="3"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="1.25" iyz="0" izz="1"/>
    </inertial>
  </link>
  <joint name="hinge" type="continuous">
    <parent link="base"/><child link="arm"/><axis xyz="0 1 0"/>
  </joint>
</robot>)";

LoadedPeer load_fake() {
  Diagnostics diagnostics;
  auto peer = load_peer(TREELINE_FAKE_PEER, diagnostics);
  for (const auto& diagnostic : diagnostics.list()) ADD_FAILURE() << to_string(diagnostic);
  if (!peer) throw std::runtime_error("not loaded");
  return *peer;
}

std::optional<BenchReport> bench_pendulum(const std::string& scene_text) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(kPendulum, "pendulum.urdf", diagnostics);
  if (!robot) return std::nullopt;
  const auto scene = parse_scene(scene_text, "scene.yaml", *robot, diagnostics);
  if (!scene) return std::nullopt;
  BenchOptions options;
  options.states = 12;
  options.flags = "-O0";
  options.timing = {1, 1};
  options.peers.peers = {load_fake()};
  options.peers.absent = {"Absent"};
  return run_bench(*robot, *scene, options, diagnostics);
}

std::vector<const BenchRow*> peer_rows(const BenchFunction& made) {
  std::vector<const BenchRow*> rows;
  for (const BenchRow& row : made.rows) {
    if (row.variant.group == VariantGroup::peer) rows.push_back(&row);
  }
  return rows;
}

const BenchFunction& find(const BenchReport& report, Function function) {
  return *std::find_if(report.functions.begin(), report.functions.end(),
                       [&](const BenchFunction& made) { return made.function == function; });
}

void expect_measured(const BenchReport& report) {
  const auto masses = peer_rows(find(report, Function::mass_matrix));
  ASSERT_EQ(masses.size(), 1U);
  EXPECT_EQ(masses[0]->variant.name, "Fake");
  EXPECT_NEAR(masses[0]->norm.median, 1e-9, 1e-15);  // a double's rounding of 2 (1 + 1e-9)
  EXPECT_NEAR(masses[0]->component.worst, 1e-9, 1e-15);
  EXPECT_GT(masses[0]->timing.nanoseconds, 0);
  const auto forward = peer_rows(find(report, Function::forward_dynamics));
  ASSERT_EQ(forward.size(), 2U);
  EXPECT_EQ(forward[0]->variant.name, "Fake, first");
  EXPECT_EQ(forward[1]->variant.name, "Fake, second");
  EXPECT_LT(forward[1]->norm.median, 1e-14);
}

void expect_left_out(const BenchReport& report) {
  const BenchFunction& inverse = find(report, Function::inverse_dynamics);
  EXPECT_TRUE(peer_rows(inverse).empty());
  ASSERT_EQ(inverse.disagreeing.size(), 1U);
  EXPECT_EQ(inverse.disagreeing[0].variant.name, "Fake");
  EXPECT_EQ(inverse.disagreeing[0].norm.median, 1);
  EXPECT_NE(print_table(report).find("left out: Fake disagrees"), std::string::npos);
}

void expect_remarks(const BenchReport& report) {
  ASSERT_EQ(report.peers.size(), 1U);
  EXPECT_EQ(report.peers[0].name, "Fake");
  EXPECT_EQ(
      report.peers[0].remarks,
      (std::vector<std::string>{
          "moves arm alone for inverse_dynamics nonlinear_effects mass_matrix forward_dynamics",
          "is not adapted for nonlinear_effects"}));
  const std::string table = print_table(report);
  EXPECT_NE(table.find("forward_dynamics; is not adapted for nonlinear_effects\n"),
            std::string::npos);
  EXPECT_NE(table.find("without Absent: "), std::string::npos);
}

void expect_json(const BenchReport& report) {
  std::istringstream lines(print_json_lines(report));
  int measured = 0;
  int disagreeing = 0;
  for (std::string line; std::getline(lines, line);) {
    const auto object = nlohmann::json::parse(line);
    if (object.contains("peers")) {
      EXPECT_EQ(object["peers"][0]["release"], "1.2");
      EXPECT_EQ(object["absent_peers"][0], "Absent");
    }
    measured += object.value("group", "") == "peer" && object.contains("variant") ? 1 : 0;
    disagreeing += object.contains("disagrees") ? 1 : 0;
  }
  EXPECT_EQ(measured, 3);
  EXPECT_EQ(disagreeing, 1);
}

/// Expects marks for the legend and for each row of the peer, but not for rows that disagree.
void expect_marks(const BenchReport& report) {
  const std::string svg = draw_svg(report);
  int marks = 0;
  for (auto at = svg.find("<title>Fake"); at != std::string::npos;
       at = svg.find("<title>Fake", at + 1)) {
    ++marks;
  }
  EXPECT_EQ(marks, 4);
  EXPECT_NE(svg.find("beside Fake 1.2"), std::string::npos);
}

TEST(Peers, AreMeasuredBesideOurs) {
  const auto report = bench_pendulum(
      "functions: [inverse_dynamics, nonlinear_effects, mass_matrix, forward_dynamics]\n");
  ASSERT_TRUE(report);
  expect_measured(*report);
  expect_left_out(*report);
  expect_remarks(*report);
  expect_json(*report);
  expect_marks(*report);
}

// A pendulum whose end is held does not move, whatever forces hold it.
TEST(Peers, AreComparedByTheMotionWhereRowsAreHeld) {
  const auto report = bench_pendulum(
      "constraints: [{name: end, between: [arm, world], origin: {xyz: [0, 0, -1]}, rows: [x, z]}]\n"
      "functions: [constrained_forward_dynamics]\n");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->peers.at(0).remarks,
            (std::vector<std::string>{"moves arm alone for constrained_forward_dynamics",
                                      "holds end between arm and the world"}));
  const auto rows = peer_rows(find(*report, Function::constrained_forward_dynamics));
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_LT(rows[0]->norm.worst, 1e-14);
  EXPECT_NE(print_table(*report).find("compared by qdd"), std::string::npos);
}

TEST(Peers, AreNotAskedToHoldWhatTheyCannot) {
  const auto report = bench_pendulum(
      "couplings: [{name: brake, joints: {hinge: 1}}]\n"
      "functions: [constrained_forward_dynamics]\n");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->peers.at(0).remarks.back(),
            "is not asked for constrained_forward_dynamics with couplings");
}

TEST(Peers, SayWhatTheyCannotDo) {
  const auto report = bench_pendulum("base: floating\nfunctions: [gravity]\n");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->peers.at(0).remarks,
            (std::vector<std::string>{"has no floating base", "is not adapted for gravity"}));
}

TEST(Peers, AreToldThatTheRobotIsNotThere) {
  const PeerDescription description{false, {0, 0, -9.81}, {"arm"}, {}};
  const OpenedPeer opened = open_peer(load_fake(), "nowhere.urdf", description, {});
  EXPECT_TRUE(opened.routines.empty());
  EXPECT_EQ(opened.sentences, std::vector<std::string>{"cannot read the robot"});
}

std::string fault_of(const std::filesystem::path& module) {
  Diagnostics diagnostics;
  EXPECT_FALSE(load_peer(module, diagnostics));
  if (diagnostics.list().size() != 1) return {};
  EXPECT_EQ(diagnostics.list()[0].severity, Severity::error);
  EXPECT_EQ(diagnostics.list()[0].file, module);
  return diagnostics.list()[0].fault;
}

TEST(LoadPeer, RefusesWhatIsNone) {
  EXPECT_EQ(fault_of(TREELINE_LATER_PEER),
            "is of version 4 of the interface, this program of version 3");
  EXPECT_EQ(fault_of(TREELINE_NO_PEER), "is no module of a peer: it has no symbol treeline_peer");
  const TemporaryFolder work;
  const auto broken = work.path() / "broken.so";
  std::ofstream(broken) << "no library";
  EXPECT_TRUE(fault_of(broken).starts_with("cannot be loaded: ")) << fault_of(broken);
  EXPECT_TRUE(fault_of(work.path() / "absent.so").starts_with("cannot be loaded: "));
}

TEST(FindPeers, LoadsWhatIsNamedAndSaysWhatIsAbsent) {
  Diagnostics diagnostics;
  const FoundPeers found = find_peers({TREELINE_FAKE_PEER}, diagnostics);
  ASSERT_EQ(found.peers.size(), 1U);
  EXPECT_EQ(found.peers[0].release, "1.2");
  // There is no module beside this test.
  EXPECT_EQ(found.absent,
            (std::vector<std::string>{"KDL", "DART", "Pinocchio", "MuJoCo", "dynibo", "CasADi"}));
  EXPECT_TRUE(diagnostics.list().empty());
}

}  // namespace
}  // namespace treeline::tests
