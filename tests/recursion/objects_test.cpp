#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <set>

#include "interpreter/object_forward_dynamics.hpp"
#include "mechanism/build_mechanism.hpp"
#include "mechanism/digits50_from_file.hpp"
#include "oracle/model_from_robot.hpp"
#include "program/evaluate.hpp"
#include "recursion/function_results.hpp"
#include "recursion/least_flops.hpp"
#include "recursion/methods/object_forward_dynamics.hpp"
#include "recursion/routes/trace_function.hpp"

// The functions about objects, every route, for random robots with random objects, compared with
// the interpreter's Chang chapter 7 in 50 digits; also in states that do not close the chain, since
// both must agree about drift. Would catch: a wrong formula, sign, axes or reference point in
// either, a linkage that one of them defines differently, and an object whose cost contains that of
// other parts.

namespace treeline::tests {
namespace {

using interpreter::PerRobot;

struct ObjectInputs {
  std::vector<double> q, qd, qdd_0, tau, xdd_object, internal, stabilisation;
};

struct Held {
  const char* name;
  std::vector<int> grasps;  ///< number of grasps of each object
  bool floating_base = false;
  double mimic = 0;
  double ball = 0;    ///< see `JointMix`
  double drives = 0;  ///< chance of a rotor, of friction, and of a spring
};

std::ostream& operator<<(std::ostream& out, const Held& held) {
  return out << held.name;
}

struct ObjectCase {
  RandomMechanism made;
  ObjectInputs in;
  std::vector<Digits50> q;  ///< before rounding; quaternions of unit length
  double growth = 1;        ///< largest condition number that amplifies rounding
};

template <class To>
interpreter::Vector<To> vector_of(const std::vector<double>& values) {
  interpreter::Vector<To> v(static_cast<Eigen::Index>(values.size()));
  for (Eigen::Index i = 0; i < v.size(); ++i) v(i) = To(values[static_cast<std::size_t>(i)]);
  return v;
}

ObjectCase draw(std::uint64_t seed, const Held& held) {
  int points = 0;
  for (const int grasps : held.grasps) points += grasps;
  ObjectCase c;
  RandomOptions options;
  options.joints = 8 * points;
  options.branching = 0.15;
  options.mix = {5, 1, 2, 0.5, 0.1, 0.3, held.ball};
  options.floating_base = held.floating_base;
  options.mimic = held.mimic;
  options.operational_points = points;
  options.rotors = options.drives = held.drives;
  c.made = random_mechanism(seed, options);
  Rng rng(seed + 5);
  int point = 0;
  for (const int grasps : held.grasps) {
    SceneObject object;
    object.name = "object_" + std::to_string(c.made.scene.objects.size());
    object.inertial = detail::random_inertial(rng, 0.4);
    object.inertial.origin.rpy = {};
    for (int i = 0; i < grasps; ++i) {
      object.grasps.push_back(
          {"point_" + std::to_string(point++), detail::random_pose(rng, 0.4, 0.4)});
    }
    c.made.scene.objects.push_back(object);
  }
  const auto chain = chain_from_scene<Digits50>(c.made.robot, c.made.scene);
  const auto drawn = [&](int count, double size) {
    return rounded_to<double>(listed(random_entries<double>(rng, count, size)));
  };
  const int nv = chain.robots[0].nv;
  const int objects = static_cast<int>(held.grasps.size());
  c.q = listed(random_position(rng, chain.robots[0], 2.0));
  c.in.q = rounded_to<double>(c.q);
  c.in.qd = drawn(nv, 2);
  c.in.qdd_0 = drawn(nv, 5);
  c.in.tau = drawn(nv, 20);
  c.in.xdd_object = drawn(6 * objects, 5);
  c.in.internal = drawn(interpreter::internal_force_count(chain), 10);
  c.in.stabilisation = {20, 100};
  const auto grips = interpreter::object_points(chain, 0);
  const auto q = vector_of<Digits50>(c.in.q);
  c.growth = std::max(condition(interpreter::mass_matrix<Digits50>(chain.robots[0], q)),
                      condition(interpreter::lambda_inverse<Digits50>(chain.robots[0], grips, q)));
  for (const auto& object : chain.objects) {
    c.growth = std::max(c.growth, condition(interpreter::grasp_description(object)));
  }
  return c;
}

/// The first case from this seed on whose hands move independently.
ObjectCase draw_regular(std::uint64_t seed, const Held& held) {
  for (;; seed += 13) {
    ObjectCase c = draw(seed, held);
    if (c.growth < 1e6) return c;
  }
}

template <class Scalar>
Results<Scalar> expected_results(Function function, const ObjectCase& c,
                                 const std::vector<Scalar>& at) {
  const auto chain = chain_from_scene<Scalar>(c.made.robot, c.made.scene);
  const auto to = [](const std::vector<double>& values) { return vector_of<Scalar>(values); };
  const PerRobot<Scalar> q{Eigen::Map<const interpreter::Vector<Scalar>>(
      at.data(), static_cast<Eigen::Index>(at.size()))},
      qd{to(c.in.qd)}, qdd_0{to(c.in.qdd_0)}, tau{to(c.in.tau)};
  if (function == Function::object_control_torque) {
    return {listed(interpreter::object_control_torque<Scalar>(
        chain, q, qd, qdd_0, to(c.in.xdd_object), to(c.in.internal))[0])};
  }
  if (function == Function::object_forward_dynamics) {
    const auto motion = interpreter::object_forward_dynamics<Scalar>(
        chain, q, qd, tau, {Scalar(c.in.stabilisation[0]), Scalar(c.in.stabilisation[1])});
    Results<Scalar> results{listed(motion.qdd[0]), listed(motion.xdd_object),
                            listed(motion.f_grasp)};
    if (motion.internal.size() > 0) results.push_back(listed(motion.internal));
    return results;
  }
  Results<Scalar> results(5);
  const auto add = [](const auto& entries, std::vector<Scalar>& to_list) {
    const auto list = listed(entries);
    to_list.insert(to_list.end(), list.begin(), list.end());
  };
  for (const auto& held : interpreter::held_poses<Scalar>(chain, q, qd)) {
    add(held[0].p, results[0]);
    add(held[0].R, results[1]);
    add(held[0].v, results[2]);
    for (std::size_t i = 1; i < held.size(); ++i) {
      const auto drift = interpreter::grasp_drift(held[0], held[i]);
      add(drift.pose, results[3]);
      add(drift.velocity, results[4]);
    }
  }
  if (results[3].empty()) results.resize(3);
  return results;
}

std::vector<std::vector<double>> arguments(const Program& program, const ObjectInputs& in) {
  std::vector<std::vector<double>> values;
  for (const Argument& argument : program.arguments) {
    const std::string& name = argument.name;
    values.push_back(name == "q"            ? in.q
                     : name == "qd"         ? in.qd
                     : name == "qdd_0"      ? in.qdd_0
                     : name == "tau"        ? in.tau
                     : name == "xdd_object" ? in.xdd_object
                     : name == "internal"   ? in.internal
                                            : in.stabilisation);
    EXPECT_EQ(static_cast<int>(values.back().size()), argument.rows) << name;
  }
  return values;
}

class Objects : public testing::TestWithParam<std::tuple<Held, int>> {
 protected:
  Objects()
      : c_(draw_regular(1 + 41 * static_cast<std::uint64_t>(std::get<1>(GetParam())),
                        std::get<0>(GetParam()))) {}
  ObjectCase c_;
};

const Held kHeld[] = {{"one_hand", {1}},           {"two_hands", {2}},
                      {"floating", {2}, true},     {"mimics", {2}, false, 0.15},
                      {"three_hands", {3}},        {"two_objects", {2, 1}},
                      {"balls", {2}, false, 0, 4}, {"drives", {2}, true, 0, 0, 0.5}};

INSTANTIATE_TEST_SUITE_P(Random, Objects,
                         testing::Combine(testing::ValuesIn(kHeld), testing::Range(0, 2)),
                         [](const auto& tested) {
                           return std::string(std::get<0>(tested.param).name) + "_" +
                                  std::to_string(std::get<1>(tested.param));
                         });

// In 50 digits with unrounded constants only the formulas can differ.
TEST_P(Objects, TemplatesAgreeInFiftyDigits) {
  const Mechanism mechanism = reduced_mechanism(c_.made.robot, c_.made.scene);
  const auto objects = objects_of<Digits50>(mechanism);
  const auto tree = holding_tree(tree_of<Digits50>(mechanism), objects);
  const auto to = [](const std::vector<double>& values) { return rounded_to<Digits50>(values); };
  const auto q = c_.q, qd = to(c_.in.qd), qdd_0 = to(c_.in.qdd_0), tau = to(c_.in.tau),
             xdd = to(c_.in.xdd_object), internal = to(c_.in.internal),
             gains = to(c_.in.stabilisation);
  const auto X = joint_transforms<Digits50>(tree, q);
  const auto expect = [&](Function function, const Results<Digits50>& actual) {
    EXPECT_LE(relative_error(actual, expected_results<Digits50>(function, c_, c_.q), 1) / c_.growth,
              1e-41)
        << function_name(function);
  };
  const auto state = object_state<Digits50>(tree, objects, X, qd);
  Results<Digits50> of_state{state.position, state.rotation, state.velocity};
  if (!state.drift.empty()) of_state.insert(of_state.end(), {state.drift, state.drift_rate});
  expect(Function::object_state, of_state);
  for (const LambdaChoice& choice : control_choices(tree)) {
    expect(
        Function::object_control_torque,
        {object_control_torque<Digits50>(tree, objects, X, {qd, qdd_0}, {xdd, internal}, choice)});
  }
  const auto factor = factor_ltdl(mass_matrix(tree, X));
  for (const LambdaChoice& choice : lambda_choices(tree)) {
    const auto motion = object_forward_dynamics<Digits50>(
        tree, objects, X, {qd, tau, gains}, choice,
        [&](const std::vector<Digits50>& forces) { return solve(factor, forces); });
    Results<Digits50> results{motion.qdd, motion.xdd_object, motion.f_grasp};
    if (!motion.internal.empty()) results.push_back(motion.internal);
    expect(Function::object_forward_dynamics, results);
  }
}

// Every route as it is emitted, in double.
TEST_P(Objects, ProgramsAgreeInDouble) {
  const Mechanism mechanism = reduced_mechanism(c_.made.robot, c_.made.scene);
  for (const Function function : kObjectFunctions) {
    const auto expected = expected_results<Digits50>(function, c_, rounded_to<Digits50>(c_.in.q));
    double worst = 0;
    std::set<std::string> names;
    for (const Program& program : trace_function(mechanism, function)) {
      const auto results = evaluate<double>(program, arguments(program, c_.in));
      // 64 ulp of the result's scale, times the condition number of the solve, as for other routes.
      const double error = relative_error(results, expected, 1) * 0x1p52 / c_.growth;
      EXPECT_LE(error, 64) << program.name << " " << describe(program.route);
      worst = std::max(worst, error);
      EXPECT_TRUE(names.insert(describe(program.route)).second) << describe(program.route);
    }
    std::cout << function_name(function) << ": " << names.size() << " routes, worst " << worst
              << " ulp over the condition " << c_.growth << '\n';
  }
}

// The constant matrices by which programs hold a flat object, beside the interpreter's other
// formulation. Would catch: rods or a warp that one of them chooses or turns otherwise.
TEST(FlatLinkage, IsTheInterpretersInverse) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const int n = 4 + static_cast<int>(seed % 3);
    const Digits50Pose plane = digits50_pose(detail::random_pose(rng, 1, 0));
    std::vector<Digits50Vector3> points;
    interpreter::GraspedObject<Digits50> object;
    for (int i = 0; i < n; ++i) {
      const Digits50Vector3 in_plane(rng.rounded(-1, 1), rng.rounded(-1, 1), i == 5 ? 0.4 : 0);
      points.push_back(plane.R * in_plane + plane.p);
      interpreter::Grasp<Digits50> grasp;
      grasp.R.setIdentity();
      grasp.p = -points.back();
      object.grasps.push_back(grasp);
    }
    const auto W = interpreter::grasp_description(object);
    const VirtualLinkage linkage = virtual_linkage(points);
    const interpreter::Matrix<Digits50> one = interpreter::Matrix<Digits50>::Identity(6 * n, 6 * n);
    const Digits50 error = (W * linkage.split - one).cwiseAbs().maxCoeff();
    EXPECT_LT(error, Digits50("1e-38"));
    const Digits50 off = (W.bottomRows(6 * (n - 1)) - linkage.read).cwiseAbs().maxCoeff();
    EXPECT_LT(off, Digits50("1e-38"));
  }
}

// An object adds its own cost and nothing else. Functions without it do not change. Its control
// costs at most, in addition to the control of the same hands, a body's Newton-Euler step, the
// rotation into the hands' axes (some 60 per hand), and W^-1 (6 N x 6 N, a multiplication and an
// addition each).
TEST(ObjectCounts, AnObjectAddsOnlyItsOwnCost) {
  for (const Held& held : {Held{"one_hand", {1}}, Held{"two_hands", {2}}}) {
    ObjectCase c = draw_regular(3, held);
    const int n = held.grasps[0];
    RandomMechanism bare = c.made;
    bare.scene.objects.clear();
    for (const Function function : kDefaultFunctions) {
      EXPECT_EQ(least_flops(c.made, function), least_flops(bare, function))
          << function_name(function);
    }
    // The same hands as operational points at the object's origin.
    RandomMechanism points = bare;
    for (int i = 0; i < n; ++i) {
      ScenePoint& point = points.scene.operational_points[static_cast<std::size_t>(i)];
      point.axes = Axes::world;
    }
    const int with = least_flops(c.made, Function::object_control_torque);
    const int without = least_flops(points, Function::control_torque);
    std::cout << held.name << ": control_torque " << without << ", object_control_torque " << with
              << " flops\n";
    EXPECT_LT(with - without, 2 * (6 * n) * (6 * n) + 150 + 120 * n) << held.name;
  }
}

// A posture without a task: the object's control costs one more Newton-Euler force and its
// distribution, and the dynamics of the closed chain need no second factorization of M.
TEST(ObjectCounts, ClosedChainDynamicsShareTheirFactorisation) {
  const ObjectCase c = draw_regular(3, {"two_hands", {2}});
  const int closed = least_flops(c.made, Function::object_forward_dynamics);
  const int open = least_flops(c.made, Function::forward_dynamics);
  const int lambda_inv = least_flops(c.made, Function::lambda_inverse);
  std::cout << "forward_dynamics " << open << ", lambda_inverse " << lambda_inv
            << ", object_forward_dynamics " << closed << " flops\n";
  EXPECT_LT(closed, 2 * open + lambda_inv + 1500);
}

}  // namespace
}  // namespace treeline::tests
