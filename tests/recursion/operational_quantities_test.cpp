#include "recursion/methods/operational_quantities.hpp"

#include <gtest/gtest.h>

#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "program/evaluate.hpp"
#include "recursion/checked_programs.hpp"
#include "recursion/methods/point_motion.hpp"
#include "recursion/seeded.hpp"
#include "recursion/tree/deferred_rotations.hpp"

// Velocities, accelerations and Khatib's quantities of operational points on reduced mechanisms, by
// every route, compared with the interpreter for the robot as written in the files. Would catch: a
// wrong formula or sign, rows in wrong axes, and a route that is offered where it does not apply.

namespace treeline::tests {
namespace {

namespace ip = interpreter;

std::vector<Seeded> operational_quantities_robots() {
  std::vector<Seeded> all;
  const auto add = [&](RandomOptions options, int seeds) {
    for (int i = 0; i < seeds; ++i) all.push_back({2100 + all.size(), options});
  };
  add({.joints = 9, .branching = 0, .operational_points = 1}, 4);
  add({.joints = 9, .branching = 0.3, .operational_points = 2, .all_rows = false}, 4);
  add({.joints = 7, .branching = 0.3, .floating_base = true, .operational_points = 2}, 4);
  add({.joints = 9, .branching = 0.1, .mimic = 0.3, .operational_points = 1, .all_rows = false}, 4);
  add({.joints = 8,
       .branching = 0.1,
       .rotors = 0.7,
       .drives = 0.5,
       .operational_points = 1,
       .all_rows = false},
      3);
  add({.joints = 6, .branching = 0.1, .mix = {3, 1, 2, 1, 1, 2}, .all_rows = false}, 4);
  add({.joints = 5, .branching = 0.1, .mix = {3, 1, 1, 1, 0, 1, 5}, .all_rows = false}, 4);
  return all;
}

constexpr std::array kOperationalQuantities = {Function::point_velocity,
                                               Function::point_acceleration,
                                               Function::dynamically_consistent_inverse,
                                               Function::null_space_projector,
                                               Function::operational_bias_force,
                                               Function::operational_gravity};

/// Solved as it is: what yields is compared by `check`.
Scene solved_exactly(Scene scene) {
  scene.singular = SingularTasks::exact;
  return scene;
}

/// A robot with inputs at which it can do its task.
struct DrawnQuantities {
  RandomMechanism made;
  Oracle<Digits50> oracle;
  Inputs<Digits50> in;
  Yardstick size;
};

/// The first from the seed on.
DrawnQuantities draw(Seeded robot) {
  while (true) {
    const RandomMechanism made = random_mechanism(robot.seed, robot.options);
    const Oracle<Digits50> oracle(made.robot, made.scene);
    Rng rng(robot.seed + 7);
    // The arguments are doubles, so that they are the same for programs.
    const auto in = rounded_to<Digits50>(rounded_to<double>(oracle.random_inputs(rng)));
    const Yardstick size = yardstick(oracle, in);
    if (size.condition_task < 1e7) return {made, oracle, in, size};
    robot.seed += 1000;
  }
}

class OperationalQuantities : public testing::TestWithParam<Seeded> {
 protected:
  explicit OperationalQuantities(const DrawnQuantities& drawn = draw(GetParam()))
      : mechanism_(reduced_mechanism(drawn.made.robot, solved_exactly(drawn.made.scene))),
        oracle_(drawn.oracle),
        points_(points_from_scene(oracle_.model(), drawn.made.scene.operational_points)),
        in_(drawn.in),
        size_(drawn.size) {}

  /// Factor by which the solves may amplify rounding.
  [[nodiscard]] double growth(Function function) const {
    return solve_of(function) == Solve::none
               ? 1
               : std::max(1.0, size_.condition_task) * std::max(1.0, size_.condition_M);
  }

  [[nodiscard]] std::vector<Digits50> expected(Function function) const {
    const auto& model = oracle_.model();
    const auto vector = [](const std::vector<Digits50>& x) {
      return ip::Vector<Digits50>(
          ip::Vector<Digits50>::Map(x.data(), static_cast<Eigen::Index>(x.size())));
    };
    const auto q = vector(in_.q), qd = vector(in_.qd), qdd = vector(in_.qdd);
    switch (function) {
      case Function::point_velocity:
        return listed(ip::point_velocity<Digits50>(model, points_, q, qd));
      case Function::point_acceleration:
        return listed(ip::point_acceleration<Digits50>(model, points_, q, qd, qdd));
      case Function::dynamically_consistent_inverse:
        return listed(ip::dynamically_consistent_inverse<Digits50>(model, points_, q, {}));
      case Function::null_space_projector:
        return listed(ip::null_space_projector<Digits50>(model, points_, q, {}));
      case Function::operational_bias_force:
        return listed(ip::operational_bias_force<Digits50>(model, points_, q, qd, {}));
      default:
        return listed(ip::operational_gravity<Digits50>(model, points_, q, {}));
    }
  }

  Mechanism mechanism_;
  Oracle<Digits50> oracle_;
  ip::Points<Digits50> points_;
  Inputs<Digits50> in_;
  Yardstick size_;
};

INSTANTIATE_TEST_SUITE_P(Robots, OperationalQuantities,
                         testing::ValuesIn(operational_quantities_robots()));

// Only a formula can be wrong.
TEST_P(OperationalQuantities, RecursionsAgreeInFiftyDigits) {
  auto tree = tree_of<Digits50>(mechanism_);
  auto X = joint_transforms<Digits50>(tree, in_.q);
  defer_rotations(tree, X);
  const auto rows = static_cast<std::size_t>(mechanism_.task_rows());
  const auto compare = [&](Function function, const std::vector<Digits50>& actual) {
    EXPECT_LT(relative_error(Results<Digits50>{actual}, Results<Digits50>{expected(function)}, 1),
              1e-41 * growth(function))
        << function_name(function);
  };
  compare(Function::point_velocity, point_velocities<Digits50>(tree, X, in_.qd));
  compare(Function::point_acceleration, point_accelerations<Digits50>(tree, X, {in_.qd, in_.qdd}));
  const auto poses = world_poses(tree, X);
  const auto J = jacobian_inward(tree, X, task_points(tree, {}, poses), rows, poses);
  const auto Jbar = dynamically_consistent_inverse(tree, X, J);
  compare(Function::dynamically_consistent_inverse, Jbar.values());
  compare(Function::null_space_projector, null_space_projector(Jbar, J).values());
  for (const LambdaChoice& choice : lambda_choices(tree)) {
    compare(Function::operational_bias_force,
            operational_bias_force<Digits50>(tree, X, choice, rows, {}, in_.qd));
    compare(Function::operational_gravity, operational_gravity(tree, X, choice, rows, {}));
  }
}

TEST_P(OperationalQuantities, TracedFunctionsAgreeWithTheInterpreter) {
  for (const Function function : kOperationalQuantities) {
    const Results<Digits50> reference{expected(function)};
    for (const Program& program : trace_function(mechanism_, function)) {
      const auto results =
          evaluate<double>(program, CheckedPrograms::arguments(program, rounded_to<double>(in_)));
      EXPECT_LT(relative_error(results, reference, 1), 256 * 0x1p-52 * growth(function))
          << program.name << " by " << describe(program.route);
    }
  }
}

}  // namespace
}  // namespace treeline::tests
