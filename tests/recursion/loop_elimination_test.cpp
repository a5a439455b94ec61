#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>

#include "closed_robots.hpp"
#include "interpreter/loop_instances.hpp"
#include "interpreter/supported_cases.hpp"
#include "mechanism/build_mechanism.hpp"
#include "passes/count_operations.hpp"
#include "passes/passes.hpp"
#include "program/evaluate.hpp"
#include "recursion/methods/eliminated_control_torque.hpp"
#include "recursion/routes/routes_of_groups.hpp"
#include "recursion/routes/trace_function.hpp"
#include "recursion/tree/supported_mechanism.hpp"

// Passive joints of loops, eliminated or held by forces. Would catch: a wrong bias or projection, a
// force of a row with a wrong sign, rows that the rest prevents already and that share forces,
// digits lost by squares of J, results that are not finite where passive joints do not follow, and
// a route that is taken unasked where the robot comes to such poses. The oracle is the
// interpreter's KKT system in 50 digits; where passive joints yield, its own elimination.

namespace treeline::tests {
namespace {

namespace ip = interpreter;

/// A robot at a state that is exact in double, away from closed poses too.
struct ClosedCase {
  ip::Model<Digits50> model;
  ip::Loops<Digits50> loops;
  ip::ConstrainedState<Digits50> at;

  ClosedCase(const Robot& robot, const Scene& scene, std::uint64_t seed)
      : model(model_from_robot<Digits50>(robot, scene)),
        loops(loops_from_scene(model, robot, scene)) {
    Rng rng(seed);
    const auto drawn = [&](int count, double size) {
      return random_entries<Digits50>(rng, count, size);
    };
    at.q = random_position(rng, model, 0.9);
    for (Digits50& x : at.q) x = Digits50(static_cast<double>(x));
    at.qd = drawn(model.nv, 2);
    at.tau = drawn(model.nv, 20);
    at.damping = 20;
    at.stiffness = 100;
    at.loops = loops;
  }

  [[nodiscard]] Matrix50 J() const { return ip::loop_jacobian<Digits50>(model, loops, at.q); }
  /// Accelerations, and the joint forces of the loops: unique where forces of rows are not.
  [[nodiscard]] Results<Digits50> in_joints(const ip::ConstrainedMotion<Digits50>& motion) const {
    return {listed(motion.qdd), listed(Vector50(J().transpose() * motion.f))};
  }
};

template <class Scalar>
ConstrainedMotion<Scalar> eliminated(const Mechanism& seen, const LoopedVelocities& looped,
                                     const ip::ConstrainedState<Digits50>& at) {
  const auto tree = tree_of<Scalar>(seen);
  const auto q = rounded_to<Scalar>(listed(at.q)), qd = rounded_to<Scalar>(listed(at.qd)),
             tau = rounded_to<Scalar>(listed(at.tau));
  const std::vector<Scalar> gains{Scalar(20), Scalar(100)};
  const auto X = joint_transforms<Scalar>(tree, q);
  return eliminated_forward_dynamics<Scalar>(tree, X, {q, qd, tau, gains, {}, {}}, looped);
}

template <class Scalar>
ip::ConstrainedMotion<Digits50> lifted(const ConstrainedMotion<Scalar>& motion) {
  const auto qdd = rounded_to<Digits50>(motion.qdd), f = rounded_to<Digits50>(motion.f);
  return {Vector50::Map(qdd.data(), static_cast<Eigen::Index>(qdd.size())),
          Vector50::Map(f.data(), static_cast<Eigen::Index>(f.size()))};
}

/// By how much the solves of both ways amplify rounding: of M, of Lambda^-1 in the kept rows, and
/// of J_D^T J_D and what is left of M.
struct Growth {
  double forces = 1, follow = 1, rest = 1;

  Growth(const ClosedCase& c, const LoopedVelocities& looped) {
    const Matrix50 J = c.J()(looped.rows, Eigen::all);
    const Matrix50 J_D = J(Eigen::all, looped.dependent);
    const Matrix50 M = ip::mass_matrix<Digits50>(c.model, c.at.q);
    forces = std::max(condition(M), condition(Matrix50(J * M.inverse() * J.transpose())));
    follow = condition(Matrix50(J_D.transpose() * J_D));
    Matrix50 P = Matrix50::Zero(M.rows(), static_cast<Eigen::Index>(looped.independent.size()));
    P(looped.independent, Eigen::all).setIdentity();
    P(looped.dependent, Eigen::all) = -J_D.inverse() * J(Eigen::all, looped.independent);
    rest = condition(Matrix50(P.transpose() * M * P));
  }
  [[nodiscard]] double largest() const { return std::max({forces, follow, rest}); }
};

class LoopElimination : public testing::TestWithParam<ClosedRobot> {
 protected:
  LoopElimination() : read_(read_closed(GetParam())) {
    reduced_ = reduced_mechanism(read_.first, read_.second);
    seen_ = with_constraints_only(reduced_);
    LoopDependents chosen = choose_loop_dependents(seen_);
    if (!chosen.velocities) throw std::runtime_error(chosen.obstacle);
    looped_ = std::move(*chosen.velocities);
  }

  /// The first states at which nothing is near singular.
  [[nodiscard]] std::vector<ClosedCase> regular(std::size_t count) const {
    std::vector<ClosedCase> cases;
    for (std::uint64_t seed = 1; cases.size() < count; ++seed) {
      ClosedCase c(read_.first, read_.second, seed);
      if (Growth(c, looped_).largest() < 1e5) cases.push_back(std::move(c));
    }
    return cases;
  }

  [[nodiscard]] ip::TaskLaw<Digits50> law() const {
    ip::TaskLaw<Digits50> law{looped_.rule.power, {}, {}, {}};
    law.borders.assign(looped_.rule.borders.begin(), looped_.rule.borders.end());
    for (std::size_t k = 0; k < looped_.rows.size(); ++k) {
      law.pivots.emplace_back(static_cast<int>(looped_.rows[k]),
                              static_cast<int>(looped_.dependent[k]));
    }
    return law;
  }

  std::pair<Robot, Scene> read_;
  Mechanism reduced_, seen_;
  LoopedVelocities looped_;
};

INSTANTIATE_TEST_SUITE_P(Robots, LoopElimination, testing::ValuesIn(closed_robots()),
                         [](const auto& tested) { return tested.param.name; });

// In 50 digits, with nothing that yields, only the formulas can differ.
TEST_P(LoopElimination, MovesAsTheKktSystemInFiftyDigits) {
  LoopedVelocities exact = looped_;
  exact.rule = {};
  for (const ClosedCase& c : regular(4)) {
    const auto oracle =
        ip::constrained_forward_dynamics<Digits50>(c.model, ip::Points<Digits50>{}, c.at);
    const auto motion = lifted(eliminated<Digits50>(seen_, exact, c.at));
    const double error = relative_error(c.in_joints(motion), c.in_joints(oracle), 1);
    EXPECT_LE(error / Growth(c, looped_).largest(), 1e-45);
    for (Eigen::Index row = 0; row < motion.f.size(); ++row) {
      const bool kept = std::count(looped_.rows.begin(), looped_.rows.end(), row) > 0;
      EXPECT_TRUE(kept || motion.f(row) == 0) << row;
    }
  }
}

// As they are emitted, with what yields. Ordinary states differ from the KKT system by what the law
// leaves out, which is far below the rounding of double.
TEST_P(LoopElimination, YieldsAsTheInterpreterInFiftyDigits) {
  for (const ClosedCase& c : regular(2)) {
    const auto oracle = ip::eliminated_forward_dynamics<Digits50>(c.model, c.at, law());
    const auto motion = lifted(eliminated<Digits50>(seen_, looped_, c.at));
    const double growth = Growth(c, looped_).largest();
    EXPECT_LE(relative_error(c.in_joints(motion), c.in_joints(oracle), 1) / growth, 1e-45);
    const auto held =
        ip::constrained_forward_dynamics<Digits50>(c.model, ip::Points<Digits50>{}, c.at);
    EXPECT_LE(relative_error(c.in_joints(motion), c.in_joints(held), 1) / growth, 0x1p-53);
  }
}

/// Arguments of a program at a state.
std::vector<std::vector<double>> arguments_at(const Program& program, const ClosedCase& c) {
  const std::map<std::string, std::vector<double>> all{
      {"q", rounded_to<double>(listed(c.at.q))},
      {"qd", rounded_to<double>(listed(c.at.qd))},
      {"tau", rounded_to<double>(listed(c.at.tau))},
      {"stabilisation", {20, 100}}};
  std::vector<std::vector<double>> values;
  for (const Argument& argument : program.arguments) values.push_back(all.at(argument.name));
  return values;
}

/// The error of each algorithm in double, in ulp of the results' scale.
std::map<std::string, double> errors_at(const std::vector<Program>& programs, const ClosedCase& c) {
  const auto truth = c.in_joints(
      ip::constrained_forward_dynamics<Digits50>(c.model, ip::Points<Digits50>{}, c.at));
  std::map<std::string, double> errors;
  for (const Program& program : programs) {
    const auto results = evaluate<double>(program, arguments_at(program, c));
    const auto motion = lifted(ConstrainedMotion<double>{results[0], results[1]});
    errors[program.route.algorithm] = relative_error(c.in_joints(motion), truth, 1) * 0x1p52;
  }
  return errors;
}

// Both ways in double, from the same numbers.
TEST_P(LoopElimination, KeepsTheDigitsOfForces) {
  const auto programs = trace_function(reduced_, Function::constrained_forward_dynamics);
  ASSERT_EQ(programs.size(), 2U);
  std::map<std::string, double> worst;
  for (const ClosedCase& c : regular(12)) {
    const Growth growth(c, looped_);
    const auto errors = errors_at(programs, c);
    for (const auto& [algorithm, error] : errors) {
      worst[algorithm] = std::max(worst[algorithm], error);
      // 64 ulp of the result's scale, times the condition numbers of the solves: not of a square.
      const double grown =
          algorithm == kEliminatedKey
              ? std::max(std::sqrt(growth.follow), growth.rest) * std::sqrt(growth.follow)
              : growth.forces;
      EXPECT_LE(error / grown, 64) << algorithm;
    }
  }
  ASSERT_EQ(worst.count(kEliminatedKey), 1U);
  for (const auto& [algorithm, error] : worst) {
    std::cout << GetParam() << ", " << algorithm << ": at most " << error << " ulp\n";
  }
}

struct EliminatedTask {
  std::size_t robot;
  const char* points;
};

void PrintTo(const EliminatedTask& tested, std::ostream* out) {
  *out << tested.points;
}

/// Torques of motors for a task, which need not be that of closed poses.
class EliminatedTorque : public testing::TestWithParam<EliminatedTask> {};

INSTANTIATE_TEST_SUITE_P(
    Robots, EliminatedTorque,
    testing::Values(
        EliminatedTask{0, ""}, EliminatedTask{2, ""},
        EliminatedTask{3, "operational_points: [{name: hand, link: platform, rows: [x, y, z]}]\n"},
        EliminatedTask{4, "operational_points: [{name: hand, link: platform, rows: [y, z]}]\n"},
        EliminatedTask{5, "operational_points: [{name: hand, link: plate}]\n"}),
    [](const auto& tested) { return closed_robots()[tested.param.robot].name; });

TEST_P(EliminatedTorque, IsThatOfTheKktSystemInFiftyDigits) {
  ClosedRobot closed = closed_robots()[GetParam().robot];
  closed.scene += GetParam().points;
  const auto [robot, scene] = read_closed(closed);
  const Mechanism seen = with_supports(reduced_mechanism(robot, scene));
  const auto tree = tree_of<Digits50>(seen);
  LoopedVelocities looped = choose_loop_dependents(seen).velocities.value();
  looped.rule = {};
  const ClosedCase c(robot, scene, 3);
  Rng rng(9);
  ip::SupportedTask<Digits50> task;
  task.points = points_from_scene(c.model, scene.operational_points);
  task.passive = passive_velocities(c.model, robot, scene);
  task.loops = c.loops;
  task.qdd_0 = random_entries<Digits50>(rng, c.model.nv, 5);
  task.xdd_cmd = random_entries<Digits50>(rng, ip::row_count(task.points), 5);
  task.f_wanted = random_entries<Digits50>(rng, ip::row_count(task.loops), 5);
  const auto oracle = ip::supported_control_torque<Digits50>(c.model, task, c.at.q, c.at.qd);
  const auto q = listed(c.at.q), qd = listed(c.at.qd), qdd_0 = listed(task.qdd_0),
             xdd_cmd = listed(task.xdd_cmd), f_wanted = listed(task.f_wanted);
  const auto X = joint_transforms<Digits50>(tree, q);
  const auto torque = eliminated_control_torque<Digits50>(
      tree, X, {{qd, qdd_0}, xdd_cmd, f_wanted, {}}, looped, PivotRule{});
  const Results<Digits50> found{torque.tau, torque.f};
  const Results<Digits50> truth{listed(oracle.tau), listed(oracle.f)};
  EXPECT_LE(relative_error(found, truth, 1), 1e-38);
}

/// A four-bar, not closed, whose rocker points to the crank's end but for this angle: then both
/// passive joints move the rocker's end in one direction.
ClosedCase nearly_in_line(const std::pair<Robot, Scene>& read, double angle) {
  ClosedCase c(read.first, read.second, 5);
  const double crank = 0.4;
  const double rocker = std::atan2(0.12 * std::sin(crank) - 0.3, 0.12 * std::cos(crank)) + angle;
  c.at.q << Digits50(crank), Digits50(-0.7), Digits50(rocker);
  return c;
}

// With the crank as input there is no motion where coupler and rocker are in line. Near there
// digits are lost by one over the angle; forces lose none.
TEST(DeadPoints, CostDigitsAndStayFinite) {
  const auto read = read_closed(closed_robots()[0]);
  const Mechanism reduced = reduced_mechanism(read.first, read.second);
  const auto programs = trace_function(reduced, Function::constrained_forward_dynamics);
  for (const double angle : {1e-1, 3e-2, 1e-3, 1e-5, 0.0, -1e-3}) {
    const ClosedCase c = nearly_in_line(read, angle);
    std::cout << angle << " rad from a dead point:";
    for (const auto& [algorithm, error] : errors_at(programs, c)) {
      EXPECT_TRUE(std::isfinite(error)) << algorithm;
      std::cout << "  " << algorithm << " " << error << " ulp";
      const bool yields = algorithm == kEliminatedKey && std::abs(angle) < 0.02;
      EXPECT_TRUE(yields || error <= 64 / std::max(std::abs(angle), 0.01)) << algorithm;
    }
    std::cout << '\n';
  }
}

// There the answer is that of the interpreter's elimination.
TEST(DeadPoints, YieldAsTheLawSays) {
  const auto read = read_closed(closed_robots()[0]);
  const Mechanism seen = with_constraints_only(reduced_mechanism(read.first, read.second));
  const LoopedVelocities looped = choose_loop_dependents(seen).velocities.value();
  ip::TaskLaw<Digits50> law{looped.rule.power, {}, {}, {}};
  law.borders.assign(looped.rule.borders.begin(), looped.rule.borders.end());
  for (std::size_t k = 0; k < 2; ++k) {
    law.pivots.emplace_back(static_cast<int>(looped.rows[k]),
                            static_cast<int>(looped.dependent[k]));
  }
  for (const double angle : {3e-3, 1e-3, 1e-4, 0.0}) {
    const ClosedCase c = nearly_in_line(read, angle);
    const auto motion = lifted(eliminated<Digits50>(seen, looped, c.at));
    const auto oracle = ip::eliminated_forward_dynamics<Digits50>(c.model, c.at, law);
    EXPECT_LE(relative_error(c.in_joints(motion), c.in_joints(oracle), 1), 1e-35) << angle;
  }
}

/// What a four-bar's passive joints permit.
LoopDependents chosen_with(const std::string& passive) {
  const auto read = read_closed({"four_bar", "four_bar", four_bar_scene("[x, z]", passive)});
  return choose_loop_dependents(with_constraints_only(reduced_mechanism(read.first, read.second)));
}

// The crank turns fully: coupler and rocker are never in line. A driven rocker comes to poses where
// crank and coupler are.
TEST(LoopDependents, FollowWhereNoClosedPoseIsADeadPoint) {
  EXPECT_TRUE(chosen_with("[coupler_joint, rocker_joint]").velocities.value().follows);
  EXPECT_FALSE(chosen_with("[crank_joint, coupler_joint]").velocities.value().follows);
}

TEST(LoopDependents, AreThoseThatTheSceneNames) {
  for (const char* passive :
       {"[]", "[rocker_joint]", "[crank_joint, coupler_joint, rocker_joint]"}) {
    const LoopDependents chosen = chosen_with(passive);
    EXPECT_FALSE(chosen.velocities) << passive;
    EXPECT_NE(chosen.obstacle.find("under `passive`"), std::string::npos) << chosen.obstacle;
  }
}

struct CountedLoop {
  std::size_t robot;
  int arm;  ///< joints of an arm that carries it
  Function function;
  int by_forces, eliminated;  ///< at most so many operations
};

constexpr Function kMotion = Function::constrained_forward_dynamics,
                   kTorque = Function::supported_control_torque;

// As emitted but for the choice of axes. A bound that fails says that an algorithm has become
// dearer.
TEST(LoopEliminationCounts, AreAsThePageSays) {
  const CountedLoop all[] = {
      {0, 0, kMotion, 181, 189},   {2, 0, kMotion, 358, 399},   {3, 0, kMotion, 1158, 2096},
      {4, 0, kMotion, 1257, 2163}, {5, 0, kMotion, 6059, 8507}, {0, 0, kTorque, 208, 194},
      {2, 0, kTorque, 429, 415},   {3, 0, kTorque, 1380, 2075}, {4, 0, kTorque, 1555, 2119},
      {5, 0, kTorque, 8351, 8729}, {0, 6, kMotion, 1907, 1620}, {2, 6, kMotion, 2706, 2159},
      {3, 6, kMotion, 6427, 5536}, {4, 6, kMotion, 6754, 5449}, {5, 6, kMotion, 15416, 14207}};
  for (const CountedLoop& each : all) {
    const ClosedRobot& closed = closed_robots()[each.robot];
    const auto read = read_closed(closed, each.arm);
    for (const Program& program :
         trace_function(reduced_mechanism(read.first, read.second), each.function)) {
      std::vector<PassReport> log;
      const int flops = count_operations(reduce_operations(program, log)).flops();
      const bool eliminates = program.route.algorithm == kEliminatedKey;
      std::cout << closed << " on " << each.arm << " joints, " << program.name << ", "
                << program.route.algorithm << ": " << flops << " operations\n";
      EXPECT_LE(flops, eliminates ? each.eliminated : each.by_forces) << closed;
    }
  }
}

}  // namespace
}  // namespace treeline::tests
