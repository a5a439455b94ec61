#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "program/evaluate.hpp"
#include "recursion/checked_programs.hpp"
#include "recursion/template_results.hpp"

// Control torques of tasks that are done in part, by the argument `active_tasks`, every route.
// Would catch: a task that is gone and still acts, a task that is whole and has other bits than
// without the argument, rows of one point that couple by its share, shares of another point, and
// torques that do not give the motion that the law states.

namespace treeline::tests {
namespace {

using Matrix50 = interpreter::Matrix<Digits50>;
using Vector50 = interpreter::Vector<Digits50>;

/// Nine to eleven joints and two points of up to six rows, of one priority or of two.
RandomMechanism two_hands(std::uint64_t seed) {
  RandomOptions options;
  options.joints = 9 + static_cast<int>(seed % 3);
  options.branching = seed % 3 == 0 ? 0.5 : 0.1;
  options.floating_base = seed % 2 == 0;
  options.operational_points = 2;
  options.all_rows = seed % 4 == 1;
  RandomMechanism made = random_mechanism(seed, options);
  made.scene.singular = SingularTasks::exact;
  if (seed % 3 != 0) made.scene.operational_points[seed % 3 - 1].priority = 2;
  return made;
}

/// An arm with as many joints as rows.
RandomMechanism six_axes() {
  const std::string folder = TREELINE_ROBOTS_DIR "/puma560/";
  Diagnostics diagnostics;
  RandomMechanism made;
  made.robot = read_urdf(folder + "puma560.urdf", diagnostics).value();
  made.scene = read_scene(folder + "scene.yaml", made.robot, diagnostics).value();
  made.scene.singular = SingularTasks::exact;
  return made;
}

RandomMechanism with_activity(RandomMechanism made) {
  for (const ScenePoint& point : made.scene.operational_points) {
    made.scene.inputs.active_tasks.push_back(point.name);
  }
  return made;
}

Vector50 vector50(const std::vector<Digits50>& values) {
  return Eigen::Map<const Vector50>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// A state of a robot, with shares of its tasks.
struct Case {
  RandomMechanism made;
  Inputs<Digits50> in;
  Yardstick size;

  explicit Case(RandomMechanism of, std::uint64_t seed) : made(std::move(of)) {
    const Oracle<Digits50> oracle(made.robot, made.scene);
    Rng rng(seed + 31);
    in = rounded_to<Digits50>(rounded_to<double>(oracle.random_inputs(rng)));
    size = yardstick(oracle, in);
  }

  [[nodiscard]] bool has_priorities() const {
    const auto& points = made.scene.operational_points;
    return points.front().priority != points.back().priority;
  }
  [[nodiscard]] std::size_t tasks() const { return made.scene.operational_points.size(); }

  /// By every route, the shares given.
  [[nodiscard]] std::vector<RouteResults<Digits50>> torques(
      const std::vector<Digits50>& shares) const {
    const auto shared = with_activity(made);
    ModelInputs<Digits50> inputs;
    inputs.shares = shares;
    return TemplateRun<Digits50>(reduced_mechanism(shared.robot, shared.scene), in, inputs)
        .results(Function::control_torque);
  }

  [[nodiscard]] double error(const std::vector<Digits50>& tau, const Vector50& expected) const {
    return relative_error(Results<Digits50>{tau}, Results<Digits50>{listed(expected)}, size.force) /
           size.condition_M / size.condition_task;
  }
};

/// Calls `check(case)` for robots that can do all of their tasks at once; returns their number.
template <class Check>
int for_each_case(Check check) {
  int checked = 0;
  for (std::uint64_t seed = 0; seed < 48; ++seed) {
    SCOPED_TRACE(seed);
    const Case c(seed == 0 ? six_axes() : two_hands(seed), seed);
    if (!(c.size.condition_task < 1e6)) continue;
    check(c);
    ++checked;
  }
  return checked;
}

/// The points of a scene, done to the shares.
interpreter::Points<Digits50> points_of(const Case& c, const interpreter::Model<Digits50>& model,
                                        const std::vector<Digits50>& shares) {
  auto points = points_from_scene(model, c.made.scene.operational_points);
  for (std::size_t k = 0; k < points.size(); ++k) points[k].share = shares[k];
  return points;
}

const std::vector<std::vector<Digits50>> kPartly = {{0.25, 1}, {1, 0.5}, {0.75, 0.125}, {0.5, 0}};

// What the interpreter finds, and what the motion is: each task lacks what its own compliance
// takes.
TEST(TaskActivity, OfAllRoutesHasTheComplianceOfEachTask) {
  const int checked = for_each_case([&](const Case& c) {
    const auto model = model_from_robot<Digits50>(c.made.robot, c.made.scene);
    const Vector50 q = vector50(c.in.q), qd = vector50(c.in.qd), qdd_0 = vector50(c.in.qdd);
    const Vector50 xdd = vector50(c.in.xdd_cmd);
    for (const auto& shares : kPartly) {
      const auto points = points_of(c, model, shares);
      const Vector50 expected =
          interpreter::control_torque<Digits50>(model, points, q, qd, qdd_0, xdd);
      for (const auto& [route, results] : c.torques(shares)) {
        EXPECT_LE(c.error(results.front(), expected), 1e-40) << route;
      }
      if (c.has_priorities()) continue;  // rows may yield to others by a little
      const Matrix50 J = interpreter::jacobian<Digits50>(model, points, q);
      const Matrix50 A = interpreter::lambda_inverse<Digits50>(model, points, q);
      const Vector50 qdd = interpreter::forward_dynamics<Digits50>(model, q, qd, expected);
      const Vector50 F = A.ldlt().solve(Vector50(J * (qdd - qdd_0)));
      const Vector50 lacks =
          xdd - interpreter::point_accelerations<Digits50>(model, points, q, qd, qdd);
      Eigen::Index row = 0;
      for (const auto& point : points) {
        const auto count = std::count(point.rows.begin(), point.rows.end(), true);
        const Digits50 done = point.share * point.share;
        const Vector50 yields =
            (1 - done) * A.block(row, row, count, count) * F.segment(row, count);
        const Vector50 left = done * lacks.segment(row, count) - yields;
        const Digits50 scale = xdd.norm() + qdd.norm() + A.norm() * F.norm();
        EXPECT_LE(static_cast<double>(left.norm() / scale), 1e-30 * c.size.condition_task);
        row += count;
      }
    }
  });
  EXPECT_GE(checked, 8);
}

// A task that is not done is none, whatever the other one is.
TEST(TaskActivity, EverySetIsThatOfItsOwnScene) {
  const int checked = for_each_case([&](const Case& c) {
    for (std::size_t kept = 0; kept < c.tasks() && c.tasks() > 1; ++kept) {
      Case alone = c;
      alone.made.scene.operational_points = {c.made.scene.operational_points[kept]};
      const auto rows = [&](std::size_t k) {
        const auto& on = c.made.scene.operational_points[k].rows;
        return std::count(on.begin(), on.end(), true);
      };
      const auto first = c.in.xdd_cmd.begin() + (kept == 0 ? 0 : rows(0));
      alone.in.xdd_cmd.assign(first, first + rows(kept));
      std::vector<Digits50> shares(c.tasks(), 0), whole{1};
      shares[kept] = 1;
      const Vector50 expected = vector50(alone.torques(whole).front().results.front());
      for (const auto& [route, results] : c.torques(shares)) {
        // Alone nothing yields; by priority a row does, by less than a double can tell.
        EXPECT_LE(c.error(results.front(), expected), c.has_priorities() ? 0x1p-53 : 1e-40)
            << route;
      }
    }
  });
  EXPECT_GE(checked, 8);
}

// All tasks whole: the bits of the function without shares, by every route, with and without laws.
TEST(TaskActivity, WholeTasksHaveTheBitsWithoutShares) {
  std::size_t routes = 0;
  for_each_case([&](const Case& c) {
    for (const SingularTasks singular : {SingularTasks::exact, SingularTasks::smooth}) {
      RandomMechanism fixed = c.made;
      fixed.scene.singular = singular;
      const auto shared = with_activity(fixed);
      const auto own =
          trace_function(reduced_mechanism(fixed.robot, fixed.scene), Function::control_torque);
      const auto with =
          trace_function(reduced_mechanism(shared.robot, shared.scene), Function::control_torque);
      ASSERT_EQ(own.size(), with.size());
      for (std::size_t k = 0; k < own.size(); ++k) {
        auto arguments = CheckedPrograms::arguments(own[k], rounded_to<double>(c.in));
        const auto expected = evaluate<double>(own[k], arguments);
        arguments.emplace_back(c.tasks(), 1.0);
        EXPECT_EQ(evaluate<double>(with[k], arguments), expected) << describe(own[k].route);
        ++routes;
      }
    }
  });
  EXPECT_GE(routes, 40U);
}

}  // namespace
}  // namespace treeline::tests
