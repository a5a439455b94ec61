#include <cmath>
#include <iostream>

#include "choice/function_mechanisms.hpp"
#include "fixture.hpp"
#include "mechanism/find_limbs.hpp"
#include "oracle/bound.hpp"
#include "oracle/graph_run.hpp"
#include "oracle/interpret.hpp"
#include "oracle/result_sizes.hpp"
#include "oracle/subject_at.hpp"
#include "recursion/routes/trace_function.hpp"

// Functions that solve for task forces, where rows cannot be moved: always for tasks with more rows
// than freedoms, and at singularities. Every route is compared with the interpreter, which borders
// dense matrices, under the same law. Would catch: a row that is relaxed in other coordinates than
// the law states, at another border or in another order, a route that solves without the law, and
// results that are not finite.

namespace treeline::tests {
namespace {

using interpreter::Digits50;

/// Six rows, or some, at one or two points of few joints.
RandomMechanism strained_robot(std::uint64_t seed) {
  RandomOptions options;
  options.joints = 3 + static_cast<int>(seed % 5);
  options.branching = seed % 3 == 0 ? 0.3 : 0;
  options.floating_base = seed % 4 == 0;
  options.mimic = seed % 6 == 1 ? 0.3 : 0;
  options.aligned = 0.8;
  options.mix.floating = 0;
  options.operational_points = 1 + static_cast<int>(seed % 2);
  options.all_rows = seed % 3 != 1;
  RandomMechanism made = random_mechanism(seed, options);
  made.scene.singular = SingularTasks::smooth;
  made.scene.functions = {Function::lambda, Function::control_torque};
  return made;
}

/// Error of one route at one state compared with the interpreter, divided by condition number and
/// sizes of terms.
double error_of(const Program& program, Function function, const Subject<Digits50>& exact,
                const ResultSizes& sizes, const State& state) {
  const auto law = law_at(program.law.get(), state.q);
  const auto size_law = interpreter::cast<double>(law_at(law_of_sizes(program.law).get(), state.q));
  const auto relaxed = sizes.relaxed(function, size_law);
  FunctionReference reference;
  for (const Digits50& x : interpret<Digits50>(function, exact, state, law)) {
    reference.high.push_back(static_cast<double>(x));
    reference.low.push_back(static_cast<double>(x - Digits50(reference.high.back())));
  }
  reference.size = sizes.sizes(function, reference.high, size_law, relaxed);
  const auto results = GraphRun(program).results(state, Real::float64);
  EXPECT_TRUE(are_finite(results)) << describe(program.route) << ", state " << state.index;
  return error_in_ulp(results, reference, unit_of(Real::float64)) /
         sizes.conditions(function, relaxed).largest();
}

TEST(SingularTasks, OfEveryRouteAreTheInterpretersByTheSameLaw) {
  double worst = 0;
  std::size_t routes = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE(seed);
    const RandomMechanism made = strained_robot(seed);
    const auto exact = make_subject<Digits50>(made.robot, made.scene);
    const auto subject = cast<double>(exact);
    if (subject.model.nv == 0) continue;
    FunctionMechanisms mechanisms(made.robot, made.scene);
    const StateSpace space{subject, mechanisms.whole().coordinates, seed, false, {}};
    for (const Function function : made.scene.functions) {
      const auto programs = trace_function(mechanisms.of(function), function);
      for (const int index : {0, 1, 2, 4, 5, 8, 9, 11, 13}) {
        const State state = draw_state(space, index);
        const ResultSizes sizes(subject, state);
        for (const Program& program : programs) {
          const double error = error_of(program, function, exact, sizes, state);
          EXPECT_LE(error, 4096) << describe(program.route) << ", state " << index;
          worst = std::max(worst, error);
          ++routes;
        }
      }
    }
  }
  std::cout << "worst error: " << worst << " ulp times the condition\n";
  EXPECT_GE(routes, 1000U);
}

/// Far from singularities, the relaxation of rows has no effect.
TEST(SingularTasks, LeaveOrdinaryStatesAsTheBareSolveHasThem) {
  double worst = 0;
  int compared = 0;
  for (const char* name : {"puma560", "ur10e", "samm"}) {
    const Subjects smooth = load(name);
    Subjects bare = smooth;
    bare.scene.singular = SingularTasks::exact;
    const auto subject = make_subject<double>(bare.robot, bare.scene);
    const StateSpace space{subject, smooth.generation.mechanism.coordinates, 1, false, {}};
    FunctionMechanisms with(smooth.robot, smooth.scene), without(bare.robot, bare.scene);
    const auto function = Function::control_torque;
    const auto relaxed = trace_function(with.of(function), function);
    const auto exact = trace_function(without.of(function), function);
    for (int index = 0; index < 200; ++index) {
      const State state = draw_state(space, index);
      const ResultSizes sizes(subject, state);
      if (sizes.conditions(function).largest() > 1e3) continue;
      FunctionReference reference;
      reference.high = GraphRun(exact.front()).results(state, Real::float64);
      reference.low.assign(reference.high.size(), 0);
      reference.size = sizes.sizes(function, reference.high);
      for (const Program& program : relaxed) {
        const auto results = GraphRun(program).results(state, Real::float64);
        const double error =
            error_in_ulp(results, reference, 0x1p-52) / sizes.conditions(function).largest();
        EXPECT_LE(error, 64) << name << ", " << describe(program.route) << ", state " << index;
        worst = std::max(worst, error);
        ++compared;
      }
    }
  }
  std::cout << "worst difference: " << worst << " ulp times the condition, of " << compared << "\n";
  EXPECT_GE(compared, 500);
}

const Program& program_of(const Generation& generation, Function function) {
  for (const GeneratedFunction& generated : generation.functions) {
    if (generated.function == function) return generated.program;
  }
  throw std::runtime_error("not generated");
}

/// All joints move through q = 0 together, with different velocities, while the task commands the
/// same motion.
class Crossing {
 public:
  explicit Crossing(const Subjects& subjects)
      : run_(program_of(subjects.generation, Function::control_torque)),
        mechanism_(subjects.generation.mechanism) {}

  [[nodiscard]] std::vector<double> torque(double s) const {
    State state;
    state.qd.assign(static_cast<std::size_t>(mechanism_.nv()), 0.1);
    state.qdd.assign(state.qd.size(), 0);
    state.xdd_cmd.assign(static_cast<std::size_t>(mechanism_.task_rows()), 1);
    state.f_ext.assign(6 * mechanism_.external_forces.size(), 0);
    for (int i = 0; i < mechanism_.nq(); ++i) state.q.push_back(s * (1 + 0.1 * i));
    return run_.results(state, Real::float64);
  }

  /// Returns the largest torque, and the largest change of a torque between steps.
  [[nodiscard]] std::pair<double, double> measure(double step) const {
    double largest = 0, steepest = 0;
    auto before = torque(-kReach);
    for (double s = step - kReach; s < kReach; s += step) {
      auto now = torque(s);
      EXPECT_TRUE(are_finite(now)) << "at " << s;
      for (std::size_t i = 0; i < now.size(); ++i) {
        steepest = std::max(steepest, std::abs(now[i] - before[i]));
        largest = std::max(largest, std::abs(now[i]));
      }
      before = std::move(now);
    }
    return {largest, steepest};
  }

 private:
  static constexpr double kReach = 0.02;
  GraphRun run_;
  const Mechanism& mechanism_;
};

/// The change of torque per step shrinks with the step, so there is no jump.
TEST(SingularTasks, AreCrossedWithoutAStepOfTorque) {
  for (const char* name : {"puma560", "ur10e", "samm", "planar3r"}) {
    SCOPED_TRACE(name);
    const Subjects subjects = load(name);
    const Crossing crossing(subjects);
    const auto [largest, coarse] = crossing.measure(1e-5);
    const auto [same, fine] = crossing.measure(5e-6);
    EXPECT_LT(fine, 0.75 * coarse + 1e-9 * largest);
    EXPECT_LT(largest, 1e5);
    std::cout << name << ": at most " << largest << " N m, " << fine << " in a step of 5e-6 rad\n";
  }
}

/// Hands that hold an object are compared with 50 digits also where they cannot move: elbows are
/// straight at q = 0.
TEST(SingularTasks, OfHandsOnAnObjectAreCompared) {
  Subjects subjects = load("humanoid24", "scene_box.yaml");
  auto& functions = subjects.generation.functions;
  std::erase_if(functions, [](const GeneratedFunction& each) {
    return solve_of(each.function) == Solve::none || !needs_objects(each.function);
  });
  ASSERT_EQ(functions.size(), 2U);
  ReferenceOptions options;
  options.states = kStatesOfEveryClass;
  const auto references =
      make_references(subjects.robot, subjects.scene, subjects.generation, options);
  const auto subject = make_subject<double>(subjects.robot, subjects.scene);
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const Bound bound = find_bound(i, functions[i].function, references);
    double worst_bare = 0;
    for (const StateReference& reference : references) {
      const FunctionReference& at = reference.functions[i];
      EXPECT_FALSE(at.singular) << functions[i].program.name << " " << reference.state.index;
      if (at.singular) continue;
      EXPECT_LE(error_in_ulp(at.graph, at, unit_of(Real::float64)), bound.at(at))
          << functions[i].program.name << " " << reference.state.index;
      const ResultSizes sizes(subject, reference.state);
      worst_bare = std::max(worst_bare, sizes.conditions(functions[i].function).largest());
    }
    EXPECT_GT(worst_bare, 1e12) << "no state was singular";
  }
}

}  // namespace
}  // namespace treeline::tests
