#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "program/evaluate.hpp"
#include "recursion/function_results.hpp"
#include "recursion/methods/task_law.hpp"
#include "recursion/routes/trace_function.hpp"

// Effective masses on the way into a singularity, against 1 / (n^T Lambda_c^-1 n) in 50 digits: an
// arm of three links whose tip touches something along the stretched arm. Would catch: a mass that
// falls where it grows, a cap below what the header states, digits that are lost long before the
// cap, functions about impulses that leave out what a scene holds without a word, and a way to take
// it in that moves what is held.

namespace treeline::tests {
namespace {

/// `exponent` of ten of all masses, as in "e-9".
std::string arm(const std::string& exponent) {
  std::string text = "<robot name='arm'><link name='l0'/>";
  for (int i = 1; i <= 3; ++i) {
    const std::string n = std::to_string(i), before = std::to_string(i - 1);
    text += "<link name='l" + n + "'><inertial><origin xyz='0.2 0 0'/><mass value='2" + exponent +
            "'/><inertia ixx='0.01" + exponent + "' iyy='0.03" + exponent + "' izz='0.03" +
            exponent + "' ixy='0' ixz='0' iyz='0'/></inertial></link><joint name='j" + n +
            "' type='revolute'><parent link='l" + before + "'/><child link='l" + n +
            "'/><origin xyz='" + (i == 1 ? "0 0 0" : "0.4 0 0") +
            "'/><axis xyz='0 0 1'/><limit lower='-2' upper='2' effort='9' velocity='3'/></joint>";
  }
  return text + "</robot>";
}

struct Scenery {
  Robot robot;
  Scene scene;
};

Scenery read_arm(const std::string& more, const std::string& exponent = "") {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(arm(exponent), "arm.urdf", diagnostics);
  const auto scene = parse_scene(
      "base: fixed\ncontacts: [{name: tip, link: l3, origin: {xyz: [0.4, 0, 0]}}]\n" + more,
      "scene.yaml", *robot, diagnostics);
  for (const Diagnostic& each : diagnostics.list()) {
    if (each.severity == Severity::error) ADD_FAILURE() << to_string(each);
  }
  return {*robot, *scene};
}

template <class Scalar>
double mass_by(const Program& program, const std::vector<std::vector<double>>& arguments) {
  std::vector<std::vector<Scalar>> given;
  for (const auto& argument : arguments) given.push_back(rounded_to<Scalar>(argument));
  return static_cast<double>(evaluate<Scalar>(program, given).front().front());
}

/// Bends from ordinary ones to none, each less than the one before.
std::vector<double> bends() {
  std::vector<double> bends;
  for (double bend = 1; bend > 1e-13; bend *= 0.7) bends.push_back(bend);
  bends.push_back(0);
  return bends;
}

/// 1 / (n^T Lambda_c^-1 n), infinite where nothing moves.
double exact_mass(const Scenery& arm, const std::vector<std::vector<double>>& arguments) {
  namespace ip = interpreter;
  const auto model = model_from_robot<Digits50>(arm.robot, arm.scene);
  const auto contacts = points_from_scene(model, arm.scene.contacts);
  ip::Vector<Digits50> q(3), n(3);
  for (Eigen::Index i = 0; i < 3; ++i) {
    q(i) = arguments[0][static_cast<std::size_t>(i)];
    n(i) = arguments[1][static_cast<std::size_t>(i)];
  }
  const Digits50 c = ip::mobilities_along<Digits50>(model, contacts, q, n)(0);
  return c > Digits50("1e-40") ? static_cast<double>(Digits50(1 / c))
                               : std::numeric_limits<double>::infinity();
}

template <class Scalar>
void expect_growth(const Scenery& arm, const Program& program) {
  const double cap = 1 / program.law->rule.borders.front();
  double before = 0, ordinary = 0;
  for (const double bend : bends()) {
    SCOPED_TRACE(testing::Message() << describe(program.route) << ", bend " << bend);
    const std::vector<std::vector<double>> arguments{{0, bend, 0}, {1, 0, 0}};
    const double exact = exact_mass(arm, arguments);
    const double mass = mass_by<Scalar>(program, arguments);
    if (bend == 1) ordinary = exact;
    // Rounding of 1 / mass is relative to what is ordinary.
    const double rounding = 64 * std::numeric_limits<Scalar>::epsilon() * mass / ordinary;
    EXPECT_LE(mass, exact * (1 + rounding));
    EXPECT_LE(mass, cap * (1 + rounding));
    EXPECT_GE(mass, before * (1 - rounding)) << "falls";
    if (exact < cap) {
      EXPECT_GE(mass, exact * (1 - std::pow(exact / cap, 4) - rounding));
    }
    EXPECT_GE(mass, 0.3 * std::min(exact, cap));
    before = mass;
  }
  EXPECT_NEAR(before, cap, 1e-2 * cap);
}

TEST(EffectiveMass, GrowsToItsCapAsAnArmIsStretched) {
  const Scenery arm = read_arm("functions: [effective_mass]\n");
  const auto programs =
      trace_function(reduced_mechanism(arm.robot, arm.scene), Function::effective_mass);
  EXPECT_GE(programs.size(), 3U);
  for (const Program& program : programs) expect_growth<double>(arm, program);
  // As far out as c has digits: the exact mass is right to 1e-4 of it at a bend of 1e-4 rad.
  EXPECT_GT(1 / programs.front().law->rule.borders.front(), 1e9);
}

// Of arms of two micrograms too, whose inverse inertias to the fourth are beyond the range of
// float.
TEST(EffectiveMass, GrowsInFloatToo) {
  for (const char* const exponent : {"", "e-9", "e6"}) {
    const Scenery arm = read_arm("real: float\nfunctions: [effective_mass]\n", exponent);
    for (const Program& program :
         trace_function(reduced_mechanism(arm.robot, arm.scene), Function::effective_mass)) {
      expect_growth<float>(arm, program);
    }
  }
}

TEST(EffectiveMass, StatesItsCap) {
  const Scenery arm = read_arm("functions: [effective_mass]\n");
  const Program program =
      trace_function(reduced_mechanism(arm.robot, arm.scene), Function::effective_mass).front();
  const double cap = 1 / program.law->rule.borders.front();
  const auto at = program.singular.find("a cap of ");
  ASSERT_NE(at, std::string::npos) << program.singular;
  EXPECT_NEAR(std::stod(program.singular.substr(at + 9)), cap, 0.05 * cap);
}

// With `singular: exact` it is the plain inverse.
TEST(EffectiveMass, IsInfiniteWhereThatIsAskedFor) {
  const Scenery arm = read_arm("singular: exact\nfunctions: [effective_mass]\n");
  for (const Program& program :
       trace_function(reduced_mechanism(arm.robot, arm.scene), Function::effective_mass)) {
    EXPECT_GT(mass_by<double>(program, {{0, 0, 0}, {1, 0, 0}}), 1e14);
  }
}

TEST(Impulses, SayWhatTheyLeaveOut) {
  const Scenery alone = read_arm("");
  const Scenery held = read_arm(
      "constraints: [{name: pin, between: [l3, world], origin: {xyz: [0.4, 0, 0]}, rows: [x]}]\n");
  for (const Function function : {Function::contact_inverse_inertia, Function::effective_mass,
                                  Function::impulse_response, Function::link_inverse_inertias}) {
    const auto equation = [&](const Scenery& arm) {
      return trace_function(reduced_mechanism(arm.robot, arm.scene), function).front().equation;
    };
    EXPECT_EQ(equation(alone).find("of the robot alone"), std::string::npos);
    EXPECT_NE(equation(held).find("of the robot alone: constraints of the scene are not held"),
              std::string::npos)
        << equation(held);
  }
}

interpreter::Matrix<double> matrix_by(const Scenery& arm, Function function,
                                      const std::vector<double>& q, Eigen::Index rows) {
  const auto program = trace_function(reduced_mechanism(arm.robot, arm.scene), function).front();
  const auto entries = evaluate<double>(program, {q}).front();
  return Eigen::Map<const interpreter::Matrix<double>>(entries.data(), rows, 3);
}

/// qdd of an arm that a constraint holds, with a force on its tip.
interpreter::Vector<double> held_acceleration(const Program& program, const std::vector<double>& q,
                                              const std::vector<double>& f_ext) {
  std::vector<std::vector<double>> arguments;
  for (const Argument& argument : program.arguments) {
    const auto size = static_cast<std::size_t>(argument.rows * argument.cols);
    arguments.push_back(argument.name == "q"       ? q
                        : argument.name == "f_ext" ? f_ext
                                                   : std::vector<double>(size, 0.3));
  }
  const auto qdd = evaluate<double>(program, arguments).front();
  return Eigen::Map<const interpreter::Vector<double>>(qdd.data(), 3);
}

// What the pages say of impulses on a robot that is held: the jump keeps the constraint, and what
// of the momentum the impulse does not bring, the constraint brings.
TEST(Impulses, OfARobotThatIsHeldAreDifferencesOfItsAccelerations) {
  const Scenery arm = read_arm(
      "constraints: [{name: pin, between: [l2, world], origin: {xyz: [0.4, 0, 0]}, rows: [x]}]\n"
      "external_forces: [{name: push, link: l3, origin: {xyz: [0.4, 0, 0]}}]\n"
      "operational_points: [{name: tip, link: l3, origin: {xyz: [0.4, 0, 0]}, rows: [x, y]}]\n");
  const std::vector<double> q{0.3, 0.5, -0.4};
  const interpreter::Vector<double> y = Eigen::Vector2d(3, -5);
  const auto program = trace_function(reduced_mechanism(arm.robot, arm.scene),
                                      Function::constrained_forward_dynamics)
                           .front();
  const interpreter::Vector<double> dqd = held_acceleration(program, q, {y(0), y(1), 0, 0, 0, 0}) -
                                          held_acceleration(program, q, {0, 0, 0, 0, 0, 0});
  const auto J_s = matrix_by(arm, Function::constraint_jacobian, q, 1);
  const auto M = matrix_by(arm, Function::mass_matrix, q, 3);
  const auto J = matrix_by(arm, Function::jacobian, q, 2);
  EXPECT_GT(dqd.norm(), 1);
  EXPECT_NEAR((J_s * dqd).norm(), 0, 1e-12 * dqd.norm());
  const interpreter::Vector<double> from_pin = M * dqd - J.transpose() * y;
  const double share = from_pin.dot(J_s.row(0)) / J_s.squaredNorm();
  EXPECT_LT((from_pin - share * J_s.transpose()).norm(), 1e-12 * y.norm());
  EXPECT_GT(std::abs(share), 1e-3);
  const double work = dqd.dot(J.transpose() * y);
  EXPECT_NEAR(dqd.dot(M * dqd), work, 1e-12 * work) << "the pin does no work";
}

}  // namespace
}  // namespace treeline::tests
