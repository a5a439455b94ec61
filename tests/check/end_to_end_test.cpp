#include <array>
#include <set>

#include "fixture.hpp"

// Robots of every kind are generated, compiled, run and found right. Would catch: a function that
// is called with its arguments in another order, a scale that is too small, and a kind of joint or
// scene that the check cannot handle.

namespace treeline::tests {
namespace {

void expect_passed(const CheckReport& report, std::size_t functions) {
  EXPECT_TRUE(report.passed()) << print_text(report);
  EXPECT_EQ(report.functions.size(), functions);
  for (const FunctionReport& function : report.functions) {
    EXPECT_EQ(function.states, report.states) << function.name;
    EXPECT_GT(function.states, 2 * function.singular) << function.name;
    EXPECT_GT(function.code_bytes.value_or(1), 0) << function.name;
    if (function.count && function.count->flops() == 0)
      continue;  // planar3r's gravity: it lies down
    // There are rounding errors. A check that compares a result with itself would find none.
    EXPECT_GT(function.worst.error, 0) << function.name;
    EXPECT_LE(function.median, function.percent_99) << function.name;
    EXPECT_LE(function.percent_99, function.worst.error) << function.name;
  }
}

TEST(Check, Puma560) {
  const auto report = check_or_throw(load("puma560"), quick_options(100));
  expect_passed(report, 11);
  // The wrist is singular at q5 = 0. Rows are relaxed there, and no state is left out.
  for (const FunctionReport& function : report.functions) {
    EXPECT_EQ(function.singular, 0) << function.name;
  }
}

// A plain solve has no reference where the wrist is singular. Some states are left out, and the
// report says so.
TEST(Check, Puma560SolvedAsItIs) {
  Subjects subjects = load("puma560");
  subjects.scene.singular = SingularTasks::exact;
  subjects.scene.functions = {Function::mass_matrix, Function::lambda, Function::control_torque};
  subjects.generation = generate(subjects.robot, subjects.scene);
  const auto report = check_or_throw(subjects, quick_options(100));
  expect_passed(report, 3);
  for (const FunctionReport& function : report.functions) {
    EXPECT_EQ(function.singular > 0, function.name != "mass_matrix") << function.name;
  }
}

TEST(Check, Planar3rWithSomeRows) {
  expect_passed(check_or_throw(load("planar3r"), quick_options(100)), 11);
}

TEST(Check, ExternalForce) {
  expect_passed(check_or_throw(load("puma560", "scene_contact.yaml"), quick_options(60)), 3);
}

TEST(Check, Contacts) {
  const auto wall = check_or_throw(load("humanoid24", "scene_hit_wall.yaml"), quick_options(40));
  expect_passed(wall, 8);
  const auto free = check_or_throw(load("tumbler"), quick_options(40));
  expect_passed(free, 6);
}

// Chang chapter 7: one box in two hands, with the required internal forces.
TEST(Check, Objects) {
  expect_passed(check_or_throw(load("humanoid24", "scene_box.yaml"), quick_options(40)), 4);
}

TEST(Check, CoriolisMatrixAndEnergies) {
  for (const char* name : {"puma560", "tumbler", "samm"}) {
    SCOPED_TRACE(name);
    for (const Real real : {Real::float64, Real::float32}) {
      Subjects subjects = load(name);
      subjects.scene.real = real;
      subjects.scene.functions = {Function::coriolis_matrix, Function::kinetic_energy,
                                  Function::potential_energy};
      subjects.generation = generate(subjects.robot, subjects.scene);
      expect_passed(check_or_throw(subjects, quick_options(40)), 3);
    }
  }
}

TEST(Check, Momentum) {
  for (const char* name : {"puma560", "tumbler", "samm"}) {
    SCOPED_TRACE(name);
    for (const Real real : {Real::float64, Real::float32}) {
      Subjects subjects = load(name);
      subjects.scene.real = real;
      subjects.scene.functions = {Function::centroidal_momentum_matrix,
                                  Function::centroidal_momentum,
                                  Function::centroidal_bias,
                                  Function::center_of_mass_bias_acceleration,
                                  Function::subtree_masses_and_centers,
                                  Function::kinetic_energy_derivatives,
                                  Function::centroidal_momentum_derivatives,
                                  Function::centroidal_momentum_rate_derivatives};
      subjects.generation = generate(subjects.robot, subjects.scene);
      expect_passed(check_or_throw(subjects, quick_options(40)), 8);
    }
  }
}

// At singularities of the wrist, too, where rows yield.
TEST(Check, QuantitiesOfOperationalPoints) {
  for (const char* name : {"puma560", "planar3r", "samm"}) {
    SCOPED_TRACE(name);
    Subjects subjects = load(name);
    subjects.scene.functions = {Function::point_velocity,
                                Function::point_acceleration,
                                Function::point_velocity_derivatives,
                                Function::point_acceleration_derivatives,
                                Function::dynamically_consistent_inverse,
                                Function::null_space_projector,
                                Function::operational_bias_force,
                                Function::operational_gravity};
    subjects.generation = generate(subjects.robot, subjects.scene);
    expect_passed(check_or_throw(subjects, quick_options(60)), 8);
  }
}

TEST(Check, Float) {
  const auto report = check_or_throw(load("puma560", "scene_float.yaml"), quick_options(60));
  expect_passed(report, 2);
  EXPECT_TRUE(report.single_precision);
}

// Would catch: a lane that uses the values of another one, and a row or constant that is
// distributed to the wrong lanes.
TEST(Check, Batches) {
  for (const auto& [batch, real] : {std::pair{4, Real::float64}, std::pair{16, Real::float32}}) {
    RandomOptions options;
    options.joints = 3;
    options.floating_base = true;
    Subjects subjects = draw(31, options, real);
    subjects.scene.batch = batch;
    subjects.scene.functions = {Function::forward_kinematics, Function::inverse_dynamics,
                                Function::mass_matrix};
    subjects.generation = generate(subjects.robot, subjects.scene);
    expect_passed(check_or_throw(subjects, quick_options(20)), 6);
  }
}

// Would catch: a sine that is given for another joint, or computed in addition. A mimic with a
// factor computes its own.
TEST(Check, SinesGiven) {
  for (std::uint64_t seed = 41; seed <= 43; ++seed) {
    RandomOptions options;
    options.joints = 6;
    options.floating_base = seed % 2 == 0;
    options.mimic = seed == 43 ? 0.5 : 0;
    Subjects subjects = draw(seed, options, seed == 42 ? Real::float32 : Real::float64);
    subjects.scene.sin_cos = Sines::given;
    subjects.generation = generate(subjects.robot, subjects.scene);
    const auto report = check_or_throw(subjects, quick_options(40));
    EXPECT_TRUE(report.passed()) << "seed " << seed << "\n" << print_text(report);
    for (const GeneratedFunction& generated : subjects.generation.functions) {
      if (options.mimic > 0) continue;
      EXPECT_EQ(count_operations(generated.program).sin_cos, 0) << "seed " << seed;
    }
  }
}

// At 1000 rad a sum of angle and offset has an error of 1e-13. Would catch: an offset that stays in
// an angle although full accuracy is requested.
TEST(Check, AccuracyAtLargeAngles) {
  constexpr double kFewUlp = 10;
  for (const Accuracy accuracy : {Accuracy::best, Accuracy::fastest}) {
    RandomOptions options;
    options.joints = 4;
    options.aligned = 0;
    options.mix = {1, 1, 0, 0, 0, 0};
    Subjects subjects = draw(61, options, Real::float64);
    subjects.scene.accuracy = accuracy;
    subjects.scene.functions = {Function::forward_kinematics, Function::mass_matrix};
    subjects.generation = generate(subjects.robot, subjects.scene);
    const auto report = check_or_throw(subjects, quick_options(60));
    for (const FunctionReport& function : report.functions) {
      EXPECT_EQ(function.worst.error < kFewUlp, accuracy == Accuracy::best)
          << function.name << " " << function.worst.error;
    }
  }
}

// Would catch: a report that passes whatever is proven.
TEST(Check, BrokenProofIsNoted) {
  Subjects subjects = load("planar3r");
  for (double& error : subjects.generation.functions.front().rounding.error) error *= 1e-3;
  const auto report = check_or_throw(subjects, quick_options(60));
  ASSERT_TRUE(report.functions.front().rounding.has_value());
  EXPECT_GT(report.functions.front().rounding->states, 0);
  EXPECT_GT(report.functions.front().rounding->used, 1);
  EXPECT_FALSE(report.passed());
  EXPECT_NE(print_text(report).find("what its expression graph permits"), std::string::npos);
}

// Whatever the flags are, bits are those of code compiled without contraction.
TEST(Check, FlagsThatContract) {
  CheckOptions options = quick_options(60);
  options.compile.flags = "-O2 -march=native -ffp-contract=fast";
  const auto report = check_or_throw(load("planar3r"), options);
  expect_passed(report, 11);
  EXPECT_NE(report.exact_command, report.compile_command);
}

// Floating base, planar and floating joints, mimics, locked joints, some rows, external forces,
// float and double.
TEST(Check, RandomRobots) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    RandomOptions options;
    options.joints = 4 + static_cast<int>(seed);
    options.floating_base = seed % 2 == 0;
    options.mimic = seed % 3 == 0 ? 0.4 : 0;
    options.locked = 0.1;
    options.mix.planar = 1;
    options.all_rows = seed % 4 < 2;
    options.external_forces = static_cast<int>(seed % 3);
    const Subjects subjects = draw(seed, options, seed % 4 == 3 ? Real::float32 : Real::float64);
    const auto report = check_or_throw(subjects, quick_options(60));
    EXPECT_TRUE(report.passed()) << "seed " << seed << "\n" << print_text(report);
  }
}

/// Torques of a random robot with three points in strict priority: the first has the first of
/// these.
Subjects draw_prioritized(std::uint64_t seed, RandomOptions options, Real real,
                          std::array<int, 3> priorities) {
  options.operational_points = 3;
  const RandomMechanism drawn = random_mechanism(seed, options);
  Subjects subjects{drawn.robot, drawn.scene, {}};
  subjects.scene.real = real;
  for (std::size_t k = 0; k < 3; ++k) {
    subjects.scene.operational_points[k].priority = priorities[k];
  }
  subjects.scene.functions = {Function::control_torque};
  subjects.generation = generate(subjects.robot, subjects.scene);
  return subjects;
}

// Tasks of strict priority with more rows than freedoms. Conflicting rows are relaxed, and are
// compared as well.
TEST(Check, Priorities) {
  for (std::uint64_t seed = 51; seed <= 54; ++seed) {
    RandomOptions options;
    options.joints = 7;
    options.floating_base = seed % 2 == 0;
    options.mix = {4, 1, 1, 0, 0, 1};
    const Subjects subjects =
        draw_prioritized(seed, options, seed == 53 ? Real::float32 : Real::float64, {3, 2, 1});
    const auto report = check_or_throw(subjects, quick_options(60));
    EXPECT_TRUE(report.passed()) << "seed " << seed << "\n" << print_text(report);
    EXPECT_LT(report.functions.front().singular, 20) << "seed " << seed;
  }
}

// The same in float, where what a row near its border leaves to later rows is lost in rounding.
// Each of these had states beyond a bound that knew the slope alone.
TEST(Check, PrioritiesNearBordersInFloat) {
  for (const std::uint64_t seed : {115U, 130U, 133U, 139U}) {
    RandomOptions options;
    options.joints = 7;
    const Subjects subjects = draw_prioritized(seed, options, Real::float32, {1, 2, 3});
    const auto report = check_or_throw(subjects, quick_options(300));
    EXPECT_TRUE(report.passed()) << "seed " << seed << "\n" << print_text(report);
    EXPECT_LT(report.functions.front().singular, 150) << "seed " << seed;
  }
}

// A task that no state can fulfil, four rows with three joints. A function that cannot have a value
// does not fail, but the report says so. With only a few states and no reference, the check does
// not pass.
TEST(Check, SaysWhatCanHaveNoValue) {
  Subjects subjects = load("planar3r");
  ScenePoint elbow = subjects.scene.operational_points.front();
  elbow.name = "elbow";
  elbow.link = "link2";
  subjects.scene.operational_points.push_back(elbow);
  subjects.scene.singular = SingularTasks::exact;
  subjects.scene.functions = {Function::jacobian, Function::lambda};
  subjects.generation = generate(subjects.robot, subjects.scene);
  const auto report = check_or_throw(subjects, quick_options());
  ASSERT_EQ(report.functions.size(), 2U);
  EXPECT_TRUE(report.functions[0].passed());
  EXPECT_EQ(report.functions[1].singular, report.functions[1].states);
  EXPECT_TRUE(report.functions[1].has_no_value());
  EXPECT_TRUE(report.passed());
  EXPECT_NE(print_text(report).find("lambda: no value to check"), std::string::npos);
  EXPECT_NE(print_text(report).find("1 of them without a value"), std::string::npos);
  const auto few = check_or_throw(subjects, quick_options(kStatesOfEveryClass - 1));
  EXPECT_FALSE(few.functions[1].passed());
  EXPECT_FALSE(few.passed());
  EXPECT_NE(print_text(few).find("not checked"), std::string::npos);
}

// If rows are relaxed, every state of such a task is compared, and is right.
TEST(Check, MoreRowsThanFreedomsYield) {
  Subjects subjects = load("planar3r");
  ScenePoint elbow = subjects.scene.operational_points.front();
  elbow.name = "elbow";
  elbow.link = "link2";
  subjects.scene.operational_points.push_back(elbow);
  subjects.scene.functions = {Function::lambda, Function::control_torque};
  subjects.generation = generate(subjects.robot, subjects.scene);
  const auto report = check_or_throw(subjects, quick_options());
  EXPECT_TRUE(report.passed()) << print_text(report);
  for (const FunctionReport& function : report.functions) EXPECT_EQ(function.singular, 0);
}

TEST(Check, NamedStatesAreThoseOfTheReport) {
  const Subjects subjects = load("planar3r");
  const auto report = check_or_throw(subjects, quick_options());
  std::set<int> named;
  for (const State& state : report.named_states) named.insert(state.index);
  for (const FunctionReport& function : report.functions) {
    EXPECT_TRUE(named.contains(function.worst.state)) << function.name;
  }
  // One of them alone has the same error, so it does not depend on the others.
  const FunctionReport& function = report.functions.front();
  CheckOptions one = quick_options(1);
  one.references.first = function.worst.state;
  const auto again = check_or_throw(subjects, one);
  EXPECT_EQ(again.functions.front().worst.error, function.worst.error);
}

}  // namespace
}  // namespace treeline::tests
