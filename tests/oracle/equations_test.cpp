#include "oracle/equations.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "check/fixture.hpp"
#include "data/list_data.hpp"
#include "description/scene_inputs.hpp"
#include "interpreter/supported_cases.hpp"
#include "limbed_robot.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/equation_sweeps.hpp"
#include "oracle/interpret.hpp"
#include "oracle/reference.hpp"
#include "oracle/subject_at.hpp"
#include "program/evaluate.hpp"
#include "recursion/routes/trace_function.hpp"

// Every equation of a header that has a derivative in it, for random robots and scenes: both the
// interpreter and the emitted algorithms against differences of lower functions in 50 digits. Would
// catch: a derivative that both leave out alike, such as that of axes that turn with a link, and
// gradients, momenta or brackets of joints' axes that do not belong to the energies.

namespace treeline::tests {
namespace {

/// Differences in 50 digits are right to some 24 digits of the largest term.
constexpr double kExact = 1e-18;
/// Emitted algorithms have constants in double, whose rounding solves amplify: beyond this the
/// formula is another one.
constexpr double kByProgram = 1e-6;

/// Two hands hold an object, at random places of it.
void add_object(Rng& rng, Scene& scene) {
  SceneObject object;
  object.name = "object";
  object.inertial = detail::random_inertial(rng, 0);
  object.inertial.origin.rpy = {};  // its moments are in the axes of the object
  for (const ScenePoint& point : scene.operational_points) {
    object.grasps.push_back({point.name, detail::random_pose(rng, 0.4, 0)});
  }
  scene.objects.push_back(object);
}

/// What was compared, and what went wrong.
class Tally {
 public:
  ~Tally() {
    std::cout << "  " << compared_ << " equations, worst of the interpreter " << worst_[0]
              << ", of emitted algorithms " << worst_[1] << "\n";
    EXPECT_GT(compared_, 0);
  }

  void note(Function function, bool by_program, const std::optional<double>& residual,
            std::uint64_t seed, int state) {
    if (!residual || !std::isfinite(*residual)) return;  // a solve that has none
    ++compared_;
    double& worst = worst_[by_program ? 1 : 0];
    worst = std::max(worst, *residual);
    EXPECT_LE(*residual, by_program ? kByProgram : kExact)
        << function_name(function) << ": " << find_equation(function)->text
        << (by_program ? " as emitted" : " as interpreted") << ", seed " << seed << ", state "
        << state;
  }

 private:
  int compared_ = 0;
  double worst_[2] = {};
};

bool is_offered(Function function, const Scene& scene) {
  if (!scene.objects.empty()) return needs_objects(function);
  // A base that is fixed leaves open where all masses are.
  const bool is_of_masses = info_of(function).group == FunctionGroup::center_of_mass;
  if (scene.inputs.base_parameters && is_of_masses) return false;
  const bool is_of_frames = function == Function::point_velocity_derivatives ||
                            function == Function::point_acceleration_derivatives;
  if (is_of_frames && has_center_of_mass(scene)) return false;
  return (!needs_points(function) || !scene.operational_points.empty()) &&
         (!needs_objects(function) || !scene.objects.empty()) &&
         (!needs_contacts(function) || !scene.contacts.empty()) &&
         (!needs_constraints(function) || scene.holds_rows());
}

using Choice = bool (*)(Function);
bool any(Function) {
  return true;
}
bool is_of_constraints(Function function) {
  return needs_constraints(function);
}

/// One of the emitted algorithms of each function with an equation.
std::vector<GeneratedFunction> trace_some(const Subjects& subjects, const Mechanism& mechanism,
                                          Choice choice, std::uint64_t seed) {
  std::vector<GeneratedFunction> functions;
  for (const FunctionInfo& info : kFunctions) {
    if (find_equation(info.function) == nullptr || !choice(info.function)) continue;
    if (!is_offered(info.function, subjects.scene)) continue;
    auto routes = trace_function(mechanism, info.function);
    GeneratedFunction traced;
    traced.function = info.function;
    traced.program = std::move(routes[seed % routes.size()]);
    functions.push_back(std::move(traced));
  }
  return functions;
}

std::vector<Digits50> run(const Program& program, const State& state) {
  std::vector<std::vector<Digits50>> arguments;
  for (const auto* argument : arguments_of(program, state)) {
    arguments.emplace_back(argument->begin(), argument->end());
  }
  std::vector<Digits50> entries;
  for (const auto& result : evaluate<Digits50>(program, arguments)) {
    entries.insert(entries.end(), result.begin(), result.end());
  }
  return entries;
}

/// Ordinary states, fast ones and tiny ones.
constexpr std::array kStates = {1, 3, 12};

void compare(const Subjects& subjects, std::uint64_t seed, Tally& tally, Choice choice = any) {
  const Mechanism mechanism = reduced_mechanism(subjects.robot, subjects.scene);
  const auto functions = trace_some(subjects, mechanism, choice, seed);
  const auto exact = make_subject<Digits50>(subjects.robot, subjects.scene, &mechanism);
  const StateSpace space =
      make_state_space(subjects.robot, subjects.scene, mechanism, functions, seed);
  for (const int index : kStates) {
    const State state = draw_state(space, index);
    const SubjectAt subject(exact, state);
    for (const GeneratedFunction& traced : functions) {
      tally.note(traced.function, false, equation_residual(traced.function, *subject, state), seed,
                 index);
      tally.note(traced.function, true,
                 equation_residual(traced.function, *subject, state, run(traced.program, state)),
                 seed, index);
    }
  }
}

class Equations : public testing::TestWithParam<Sweep> {};

INSTANTIATE_TEST_SUITE_P(Sweeps, Equations, testing::ValuesIn(sweeps()),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST_P(Equations, HoldForRandomRobots) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    compare(draw_subjects(GetParam(), seed), seed, tally);
  }
}

TEST(EquationsOfObjects, HoldForTwoHands) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    LimbedRobot made = make_limbed_robot({.trunk = 2, .limbs = 2, .limb_links = 7, .hands = 2});
    made.scene.base = seed % 2 == 0 ? Base::floating : Base::fixed;
    made.scene.singular = SingularTasks::exact;
    Rng rng(seed);
    made.robot.links.front().inertial = detail::random_inertial(rng, 0);
    add_object(rng, made.scene);
    compare({made.robot, made.scene, {}}, seed, tally);
  }
}

/// Constraints to the world with random rows, along the world's axes or the frame's own.
void hold_random_rows(Rng& rng, const RandomOptions& options, Subjects& subjects) {
  ScenePoint held = detail::random_point(rng, options, subjects.robot, "held");
  detail::drop_rows(rng, held);
  subjects.scene.constraints = {held};
}

TEST(EquationsOfConstraints, HoldForRandomRowsAndAxes) {
  const RandomOptions options{
      .joints = 4, .mix = {3, 0, 2, 0.3, 0, 1, 1}, .floating_base = true, .external_forces = 1};
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Subjects subjects{};
    const RandomMechanism made = random_mechanism(seed, options);
    subjects.robot = made.robot;
    subjects.scene = made.scene;
    Rng rng(seed);
    hold_random_rows(rng, options, subjects);
    compare(subjects, seed, tally, is_of_constraints);
  }
}

class EquationsOfSupports : public testing::TestWithParam<Standing> {};

INSTANTIATE_TEST_SUITE_P(Kinds, EquationsOfSupports, testing::ValuesIn(standings_and_loops()),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST_P(EquationsOfSupports, Hold) {
  const StandingCase drawn = draw_standing_regular(7, GetParam());
  if (!drawn.made.scene.holds_rows()) return;
  Tally tally;
  compare({drawn.made.robot, drawn.made.scene, {}}, 7, tally, is_of_constraints);
}

/// A blade that cannot slide sideways: x y yaw.
Subjects skate() {
  Diagnostics diagnostics;
  const auto robot = read_urdf(data_file("written/skate.urdf"), diagnostics);
  const auto scene =
      parse_scene("constraints: [{name: blade, between: [body, world], rows: [y], axes: local}]\n",
                  "skate.yaml", robot.value(), diagnostics);
  return {robot.value(), scene.value(), {}};
}

// At 1.5 m/s along the blade and 2 rad/s it goes round a circle of 0.75 m: f = m v w.
TEST(Skate, GoesRoundACircle) {
  const Subjects subjects = skate();
  const double c = std::cos(0.6), s = std::sin(0.6);
  State state;
  state.q = {0, 0, 0.6};
  state.qd = {1.5 * c, 1.5 * s, 2};
  state.tau = {0, 0, 0};
  state.others[Quantity::stabilisation] = {0, 0};
  state.others[Quantity::drift] = {0};
  const std::vector<double> expected{-3 * s, 3 * c, 0, 6};
  const auto exact = make_subject<Digits50>(subjects.robot, subjects.scene);
  const auto interpreted =
      interpret<Digits50>(Function::constrained_forward_dynamics, exact, state);
  ASSERT_EQ(interpreted.size(), expected.size());
  const Mechanism mechanism = reduced_mechanism(subjects.robot, subjects.scene);
  const auto routes = trace_function(mechanism, Function::constrained_forward_dynamics);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(static_cast<double>(interpreted[i]), expected[i], 1e-14);
    for (const Program& route : routes) {
      EXPECT_NEAR(static_cast<double>(run(route, state)[i]), expected[i], 1e-14)
          << describe(route.route);
    }
  }
}

// An acceleration along axes that turn is not the rate of the velocity along them.
TEST(EquationResidual, TellsAccelerationsFromRates) {
  const Subjects subjects = [] {
    Subjects made = skate();
    made.scene.operational_points = made.scene.constraints;
    return made;
  }();
  State state;
  state.q = {0, 0, 0.6};
  state.qd = {1, 0.5, 2};
  const auto exact = make_subject<Digits50>(subjects.robot, subjects.scene);
  EXPECT_LE(equation_residual(Function::bias_acceleration, exact, state).value(), kExact);
  EXPECT_GE(equation_residual(Function::bias_acceleration, exact, state, {Digits50(0)}).value(),
            0.1);
}

}  // namespace
}  // namespace treeline::tests
