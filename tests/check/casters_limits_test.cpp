#include <cmath>
#include <iostream>

#include "compiled_library.hpp"
#include "description/robot_queries.hpp"
#include "samm_on_casters.hpp"

// Friction cones of wheels that roll: SAMM drives on four casters, an arm rolls a disc. Would
// catch: cones about other axes than the ground's, as those of the wheels, which turn; a normal
// force that pulls; rows of another wheel; freedoms that the four wheels have on the ground alone
// and the code leaves out; and friction of wheels whose normal force nothing tells.

namespace treeline::tests {
namespace {

constexpr double kFriction = 0.2, kLeastForce = 5;
constexpr std::size_t kRowsOfWheel = 3;

std::string scene_with_cones(const std::string& base) {
  std::string text = "operational_points: [{name: base, link: base, rows: [x, y, rz]}]\n" + base +
                     "functions: [supported_control_torque, mass_matrix, "
                     "constraint_jacobian, jacobian]\nconstraints:\n";
  for (int k = 0; k < kCasters; ++k) {
    const std::string wheel = "wheel" + std::to_string(k);
    text += "  - {name: " + wheel + ", between: [" + wheel +
            ", world], rolling: {radius: 0.055}, friction: " + std::to_string(kFriction) +
            ", sides: 8, least_force: " + std::to_string(kLeastForce) + "}\n";
  }
  return text;
}

/// A base that can lift and tip, with joints that stay where they are.
std::string free_base(const std::string& locked) {
  return "base: floating\nlocked: {base_x: 0, base_y: 0, base_yaw: 0" + locked + "}\n";
}
const std::string kWithArm = free_base("") + "torque_limits: urdf\n";

Subjects samm(const std::string& base = kWithArm) {
  Diagnostics diagnostics;
  return in_scene(parse_urdf(urdf_on_casters(), "samm.urdf", diagnostics), scene_with_cones(base));
}

/// An arm that rolls a disc on a sloping table, and does not spin it there.
Subjects disc(const std::string& more) {
  Diagnostics diagnostics;
  return in_scene(
      read_urdf(std::string(TREELINE_ROBOTS_DIR) + "/ur10e/ur10e.urdf", diagnostics),
      "operational_points: [{name: tool, link: wrist_1, rows: [x, y]}]\ntorque_limits: urdf\n"
      "constraints: [{name: disc, between: [tool, world], other_origin: {xyz: [0.5, 0, 0.2], rpy: "
      "[0.3, 0, 0]}, rolling: {radius: 0.1, axis: [0, 1, 0]}, rows: [x, y, z, rz], friction: 0.5, "
      "torsional: 0.02, least_force: 2}]\nfunctions: [supported_control_torque, mass_matrix, "
      "constraint_jacobian, jacobian]\n" +
          more);
}

void expect_certified(const Subjects& subjects) {
  const auto report = check_or_throw(subjects, quick_options(20));
  EXPECT_TRUE(report.passed()) << print_text(report);
  ASSERT_TRUE(report.limits);
  EXPECT_GE(report.limits->certified, 10) << print_text(report);
}

TEST(CastersLimits, AnywhereInSpace) {
  expect_certified(samm());
}

TEST(CastersLimits, AnywhereInSpaceInC) {
  expect_certified(samm(kWithArm + "language: c\n"));
}

TEST(DiscLimits, OnATable) {
  expect_certified(disc("lanes: 1\n"));
}

TEST(DiscLimits, OnATableInFloatInC) {
  expect_certified(disc("language: c\nreal: float\n"));
}

TEST(DiscLimits, OnATableInBatches) {
  expect_certified(disc("batch: 2\n"));
}

/// A state of the space with all four wheels on the ground, turned by `yaw`.
State on_the_ground(const StateSpace& space, int index, double yaw) {
  State state = draw_state(space, index);
  const double ground[] = {0.3, -0.2, 0, 0, 0, std::sin(yaw / 2), std::cos(yaw / 2)};
  std::copy(std::begin(ground), std::end(ground), state.q.begin());
  return state;
}

// Four normal forces of which three are told by the motion.
TEST(CastersLimits, OnTheGround) {
  const Subjects subjects = samm();
  const CompiledLibrary library(subjects);
  const StateSpace space = library.states();
  std::vector<StateReference> references;
  for (int i = 0; i < 20; ++i) references.push_back({on_the_ground(space, i, 0.4 * i), {}});
  const LimitsReport report = judge_limits(subjects.robot, subjects.scene, subjects.generation,
                                           references, library.get(), false, 0);
  EXPECT_TRUE(report.passed());
  EXPECT_EQ(report.irregular, 0);
  EXPECT_GE(report.certified, 10);
  std::cout << report.certified << " of " << report.limited << " certified, worst " << report.worst
            << " ulp, " << 100 * report.of_bound << " % of what is allowed\n";
}

/// Forces of the wheels added up, and how far the worst one is outside its cone.
struct Driven {
  double forward = 0, weight = 0, beyond = -1e9, least = 1e9;
};

Driven driven_by(const double* f) {
  Driven driven;
  for (std::size_t k = 0; k < kCasters; ++k, f += kRowsOfWheel) {
    driven.forward += f[0];
    driven.weight += f[2];
    driven.beyond = std::max(driven.beyond, std::hypot(f[0], f[1]) - kFriction * f[2]);
    driven.least = std::min(driven.least, f[2]);
  }
  return driven;
}

// At rest on the ground a robot with a stiff arm shall start faster than friction permits. By
// Coulomb's law its wheels can push with that share of its weight.
TEST(CastersLimits, StartsAsFastAsFrictionPermits) {
  const Subjects subjects =
      samm(free_base(", joint1: 0, joint2: -0.5, joint3: 1, joint4: 0, joint5: 0, joint6: 0"));
  const CompiledLibrary library(subjects);
  State state = on_the_ground(library.states(), 1, 0);
  for (auto* each : {&state.qd, &state.qdd}) std::fill(each->begin(), each->end(), 0);
  std::fill(state.q.begin() + 7, state.q.end(), 0.3);
  for (auto& [quantity, values] : state.others) std::fill(values.begin(), values.end(), 0);
  state.xdd_cmd = {5, 0, 0};
  const std::size_t nv = state.qd.size(), held = kRowsOfWheel * kCasters;
  const auto wanted = library.supported(state), limited = library.limited(state);
  const Driven free = driven_by(wanted.data() + nv), kept = driven_by(limited.data() + nv);
  const double lost = limited[nv + held];
  std::cout << "wanted " << free.forward << " N of " << free.weight << " N, kept " << kept.forward
            << " N of " << kept.weight << " N; lost " << lost << " m/s^2\n";
  EXPECT_GT(free.beyond, 10);
  EXPECT_LE(kept.beyond, 1e-6);
  EXPECT_GE(kept.least, kLeastForce - 1e-6);
  EXPECT_NEAR(kept.weight, 9.81 * total_mass(subjects.robot), 1e-6);
  // Along a side of the pyramid, of which there are eight within the cone.
  const double friction = kFriction * std::cos(std::acos(-1.0) / 8);
  EXPECT_NEAR(kept.forward, friction * kept.weight, 1e-3);
  EXPECT_GT(lost, 0.5);  // forward, as wanted, so that xdd = xdd_cmd - lost is less than wanted
}

// Where the base keeps its height, no motion tells with what force a wheel stands on the ground.
TEST(CastersLimits, NeedsANormalForce) {
  Diagnostics diagnostics;
  const Robot robot = parse_urdf(urdf_on_casters(), "samm.urdf", diagnostics).value();
  const auto scene = parse_scene(scene_with_cones("passive: [base_x, base_y, base_yaw]\n"),
                                 "s.yaml", robot, diagnostics);
  ASSERT_TRUE(scene);
  EXPECT_FALSE(generate_code(robot, *scene, {"robot.urdf", "", "s.yaml", ""}, diagnostics));
  EXPECT_NE(to_string(diagnostics.list().back()).find("no joint moves it along its normal"),
            std::string::npos);
}

}  // namespace
}  // namespace treeline::tests
