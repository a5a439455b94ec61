#include "compiled_library.hpp"
#include "data/list_data.hpp"
#include "oracle/limited_optimum.hpp"
#include "program/evaluate.hpp"

// limited_control_torque in `check`. Would catch: limits that `check` passes over in silence, a
// result that is within limits and not the optimum, an optimum that is not what the cost of the
// page has, a certificate that takes the generated code's word for which limits are reached, and
// torques that change where nothing is limited.

namespace treeline::tests {
namespace {

/// An arm whose hand slides along a wall at most as friction permits.
Subjects arm(const std::string& more = "") {
  return in_scene(std::string(TREELINE_ROBOTS_DIR) + "/ur10e/ur10e.urdf",
                  "operational_points: [{name: tool, link: wrist_1, rows: [x, y]}]\n"
                  "constraints: [{name: wall, between: [tool, world], rows: [x, y, z], "
                  "friction: 0.5, least_force: 2}]\n"
                  "torque_limits: urdf\nfunctions: [supported_control_torque, mass_matrix, "
                  "constraint_jacobian, jacobian]\n" +
                      more);
}

Subjects quadruped() {
  std::string scene =
      "base: floating\noperational_points:\n  - {name: trunk, link: base}\ntorque_limits: urdf\n"
      "functions: [supported_control_torque, mass_matrix, constraint_jacobian, jacobian]\n"
      "constraints:\n";
  for (const char* foot : {"LF", "RF", "LH", "RH"}) {
    scene += "  - {name: " + std::string(foot) + ", between: [" + foot +
             "_FOOT, world], rows: [x, y, z], friction: 0.7, sides: 8}\n";
  }
  return in_scene(data_file("published/anymal_c.urdf"), scene);
}

/// Two fingers on slides that press on each other: the left one lies on the side of z of the right
/// one's frame.
Subjects jaw() {
  return in_scene(data_file("written/parallel_jaw.urdf"),
                  "constraints:\n  - {name: tips, between: [left_finger, right_finger], "
                  "origin: {xyz: [-0.02, 0, 0]}, other_origin: {xyz: [0.02, 0, 0], "
                  "rpy: [0, 1.5707963267948966, 0]}, rows: [x, y, z], friction: 0.4, "
                  "least_force: 3}\ntorque_limits: urdf\n"
                  "operational_points: [{name: wrist, link: wrist, rows: [rz]}]\n"
                  "functions: [supported_control_torque, mass_matrix, constraint_jacobian, "
                  "jacobian]\n");
}

/// A humanoid whose palms are pressed together.
Subjects palms() {
  return in_scene(std::string(TREELINE_ROBOTS_DIR) + "/humanoid24/humanoid24.urdf",
                  "operational_points: [{name: head, link: head, rows: [x, y, z]}]\n"
                  "constraints:\n  - {name: palms, between: [left_hand, right_hand], "
                  "other_origin: {xyz: [0, 0, 0.1]}, rows: [x, y, z], friction: 0.5, "
                  "least_force: 5}\ntorque_limits: urdf\n"
                  "functions: [supported_control_torque, mass_matrix, constraint_jacobian, "
                  "jacobian]\n");
}

void expect_certified(const Subjects& subjects, int states, int least) {
  const auto report = check_or_throw(subjects, quick_options(states));
  EXPECT_TRUE(report.passed()) << print_text(report);
  ASSERT_TRUE(report.limits);
  EXPECT_EQ(report.limits->states, states);
  EXPECT_GE(report.limits->certified, least) << print_text(report);
  EXPECT_NE(print_text(report).find("KKT conditions certify"), std::string::npos);
  std::cout << report.limits->certified << " of " << report.limits->limited << " certified, worst "
            << report.limits->worst << " ulp, " << 100 * report.limits->of_bound
            << " % of what is allowed" << '\n';
}

TEST(LimitsCheck, ArmAtAWall) {
  expect_certified(arm(), 40, 10);
}

TEST(LimitsCheck, ArmAtAWallInFloat) {
  expect_certified(arm("real: float\n"), 40, 10);
}

TEST(LimitsCheck, ArmAtAWallInC) {
  expect_certified(arm("language: c\n"), 40, 10);
}

TEST(LimitsCheck, ArmAtAWallInCodeForSafety) {
  expect_certified(arm("profile: misra\n"), 40, 10);
}

void expect_batch_certified(const Subjects& subjects, int least) {
  const auto report = check_or_throw(subjects, quick_options(40));
  EXPECT_TRUE(report.passed()) << print_text(report);
  ASSERT_TRUE(report.batch_limits);
  EXPECT_EQ(report.batch_limits->states, 40);
  EXPECT_EQ(report.batch_limits->limited, report.limits->limited);
  EXPECT_GE(report.batch_limits->certified, least) << print_text(report);
  EXPECT_NE(print_text(report).find("batch_limited_control_torque: something"), std::string::npos);
}

TEST(LimitsCheck, ArmAtAWallInBatches) {
  expect_batch_certified(arm("batch: 4\n"), 10);
}

TEST(LimitsCheck, ArmAtAWallInBatchesOfFloat) {
  expect_batch_certified(arm("batch: 8\nreal: float\n"), 10);
}

// In vectors, and in loops over the states.
TEST(LimitsCheck, ArmAtAWallInBatchesOfC) {
  expect_batch_certified(arm("batch: 4\nlanes: 4\nlanguage: c\n"), 10);
  expect_batch_certified(arm("batch: 2\nlanes: 1\nreal: float\nlanguage: c\n"), 10);
}

/// Without constraints there is no matrix of held rows.
Subjects passive_elbow(const std::string& more) {
  return in_scene(std::string(TREELINE_ROBOTS_DIR) + "/ur10e/ur10e.urdf",
                  "operational_points: [{name: tool, link: tool, rows: [x]}]\npassive: [elbow]\n"
                  "torque_limits: urdf\nbatch: 2\nfunctions: [supported_control_torque, "
                  "mass_matrix, jacobian]\n" +
                      more);
}

TEST(LimitsCheck, PassiveElbowInBatches) {
  expect_batch_certified(passive_elbow(""), 5);
  expect_batch_certified(passive_elbow("language: c\n"), 5);
}

const Program& program_of(const std::vector<GeneratedFunction>& functions, Function function) {
  return std::find_if(functions.begin(), functions.end(),
                      [&](const auto& each) { return each.function == function; })
      ->program;
}

// Would catch: a state that gets another one's matrices, forces or start.
TEST(LimitsCheck, ABatchGivesEachStateTheBitsItWouldGetAlone) {
  const Subjects subjects = arm("batch: 4\nlanes: 1\n");
  for (const Function function : subjects.scene.functions) {
    const auto& [functions, batch] =
        std::tie(subjects.generation.functions, subjects.generation.batch);
    ASSERT_EQ(key_of(program_of(functions, function).route),
              key_of(program_of(batch, function).route));
  }
  const CompiledLibrary library(subjects);
  const StateSpace states = library.states();
  for (int i = 0; i < 200; ++i) {
    const State state = draw_state(states, i);
    const auto alone = library.limited(state), in_batch = library.limited(state, true);
    EXPECT_TRUE(std::equal(alone.begin(), alone.end(), in_batch.begin(), in_batch.end(), same_bits))
        << "state " << i;
  }
}

// Twelve forces of which six carry nothing, a base without motors.
TEST(LimitsCheck, QuadrupedOnFourFeet) {
  expect_certified(quadruped(), 20, 10);
}

TEST(LimitsCheck, PalmsOfAHumanoid) {
  expect_certified(palms(), 20, 10);
}

// Cones between two links. Would catch: the normal's other direction, by which fingers would pull,
// and rows of another constraint's forces.
TEST(LimitsCheck, FingersPushEachOther) {
  const Subjects subjects = jaw();
  const auto& functions = subjects.generation.functions;
  const auto found = std::find_if(functions.begin(), functions.end(), [](const auto& each) {
    return each.function == Function::constraint_jacobian;
  });
  ASSERT_NE(found, functions.end());
  std::vector<std::vector<double>> arguments;
  for (const Argument& argument : found->program.arguments) {
    arguments.emplace_back(argument.rows * argument.cols, 0.0);
  }
  const auto J = evaluate<double>(found->program, arguments).front();
  ASSERT_EQ(J.size(), 9U);
  EXPECT_NEAR(J[7], 1, 1e-15);  // a force along the normal opens the jaw, on either finger
  EXPECT_NEAR(J[8], 1, 1e-15);
  const LimitFacts facts =
      describe_limits(subjects.robot, subjects.scene, subjects.generation.mechanism, functions);
  ASSERT_FALSE(facts.cones.empty());
  const LimitFacts::Row& least = facts.cones.front();
  EXPECT_EQ(least.first, 0);
  EXPECT_EQ(least.coefficients, (std::vector<double>{0, 0, -1}));
  EXPECT_EQ(least.bound, -3);
  expect_certified(subjects, 40, 10);
}

// Would catch a check that does not look: another order of levels stays within all limits and obeys
// the equations of motion.
TEST(LimitsCheck, AnotherCostIsFound) {
  const Subjects subjects = arm();
  const TemporaryFolder temporary;
  CheckOptions options = quick_options(40);
  options.folder = temporary.path() / "ur10e";
  write_folder(options.folder, subjects.generation);
  const auto header = options.folder / "limit_program.hpp";
  std::string text = read_file(header);
  const std::string from = " * 1000.0 * 1000.0 /";
  const auto at = text.find(from);
  ASSERT_NE(at, std::string::npos);
  write_file(header, text.replace(at, from.size(), " * 10.0 * 10.0 /"));
  const auto report = check_or_throw(subjects, options);
  ASSERT_TRUE(report.limits);
  EXPECT_FALSE(report.limits->passed());
  EXPECT_GT(report.limits->of_bound, 1);
  EXPECT_EQ(report.limits->beyond_limits, 0);
  EXPECT_NE(print_text(report).find("beyond its bound"), std::string::npos);
}

/// One motor of mass 2 that shall push with 7 and may with 3, and a cone that does not matter.
TEST(LimitedOptimum, IsFoundFromAnyLimits) {
  LimitProblem problem;
  problem.M = interpreter::Matrix<Digits50>::Constant(1, 1, 2);
  problem.J_s.resize(0, 1);
  problem.J_t = interpreter::Matrix<Digits50>::Constant(1, 1, 4);
  problem.tau = interpreter::Vector<Digits50>::Constant(1, 7);
  problem.f.resize(0);
  problem.hierarchy = 1000;
  LimitFacts facts;
  facts.torque = {3};
  facts.task_weights = {1};
  facts.freedoms = 1;
  EXPECT_TRUE(fits_freedoms(problem, facts, Real::float64));
  for (const int side : {-1, 0, 1}) {
    for (const int slack : {0, -1}) {
      const auto optimum = find_limited_optimum(problem, facts, {side, slack});
      ASSERT_TRUE(optimum);
      // Of 7 N 4 are missing: the mass is accelerated by 2 less, its row by 8.
      EXPECT_LT(abs(optimum->tau(0) - 3), Digits50("1e-20"));
      EXPECT_LT(abs(optimum->lost(0) - 8), Digits50("1e-20"));
      EXPECT_LT(abs(optimum->slack), Digits50("1e-20"));
      EXPECT_EQ(optimum->corrections > 0, side != 1 || slack == 0);
    }
  }
}

}  // namespace
}  // namespace treeline::tests
