// Friction at the end of a step. Would catch: M + step D with another D, step or sign, in any
// route; a step that other functions take; and friction that is implicit in name only, which makes
// stiff joints diverge. Joints of published robots are held with published stiffness and damping.
#include <gtest/gtest.h>

#include <cmath>

#include "data/list_data.hpp"
#include "description/read_urdf.hpp"
#include "description/urdf_parts.hpp"
#include "interpreter/instances.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "program/evaluate.hpp"
#include "recursion/checked_programs.hpp"
#include "recursion/routes/trace_function.hpp"

namespace treeline::tests {
namespace {

std::vector<Digits50> with_step(const Program& program, const Inputs<Digits50>& in, double step) {
  std::vector<std::vector<Digits50>> values;
  for (const Argument& argument : program.arguments) {
    const std::string& name = argument.name;
    values.push_back(name == "q"      ? in.q
                     : name == "qd"   ? in.qd
                     : name == "tau"  ? in.tau
                     : name == "step" ? std::vector<Digits50>{Digits50(step)}
                                      : in.f_ext);
  }
  return evaluate<Digits50>(program, values).front();
}

TEST(ImplicitFriction, EveryRouteSolvesWithMPlusStepD) {
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    SCOPED_TRACE(seed);
    RandomOptions options;
    options.joints = 6;
    options.branching = 0.3;
    options.floating_base = seed % 3 == 0;
    options.mimic = seed % 4 == 0 ? 0.3 : 0;
    options.rotors = seed % 2 == 0 ? 0.5 : 0;
    options.drives = 0.7;
    options.external_forces = 1;
    RandomMechanism made = random_mechanism(seed, options);
    made.scene.implicit_friction = true;
    Rng rng(seed);
    const Oracle<Digits50> oracle(made.robot, made.scene);
    const auto in = rounded_to<Digits50>(rounded_to<double>(oracle.random_inputs(rng)));
    const double step = 0.01;
    const auto vector = [](const std::vector<Digits50>& values) {
      return interpreter::Vector<Digits50>(Eigen::Map<const interpreter::Vector<Digits50>>(
          values.data(), static_cast<Eigen::Index>(values.size())));
    };
    const auto& model = oracle.model();
    const auto forces = points_from_scene(model, made.scene.external_forces);
    const auto expected = interpreter::forward_dynamics_with_implicit_drives<Digits50>(
        model, vector(in.q), vector(in.qd), vector(in.tau), forces, vector(in.f_ext),
        Digits50(step));
    const double growth = yardstick(oracle, in).condition_M;
    const Mechanism mechanism = reduced_mechanism(made.robot, made.scene);
    const auto programs = trace_function(mechanism, Function::forward_dynamics);
    EXPECT_EQ(programs.size(), find_clusters(tree_of<double>(mechanism)) ? 2U : 1U);
    for (const Program& program : programs) {
      const double error =
          relative_error<Digits50, Digits50>({with_step(program, in, step)}, {listed(expected)}, 0);
      EXPECT_LT(error, kUlpBound * 0x1p-52 * growth) << describe(program.route);
    }
    for (const Program& program : trace_function(mechanism, Function::inverse_dynamics)) {
      for (const Argument& argument : program.arguments) EXPECT_NE(argument.name, "step");
    }
  }
}

/// A robot whose joints are held: tau = g + stiffness (goal - q), with damping in the joints.
struct HeldRobot {
  Robot robot;
  Scene scene;
  std::vector<double> stiffness, goal;
};

/// Largest distance from the goal, rad, a second after 0.1 rad off in every joint, by the emitted
/// operations of forward dynamics and semi-implicit Euler steps of 1 ms.
double distance_after_a_second(HeldRobot held, bool implicit) {
  held.scene.implicit_friction = implicit;
  const Mechanism mechanism = reduced_mechanism(held.robot, held.scene);
  const Program forward = trace_function(mechanism, Function::forward_dynamics).front();
  const Program gravity = trace_function(mechanism, Function::gravity).front();
  std::vector<double> q = held.goal, qd(q.size(), 0.0);
  for (double& angle : q) angle += 0.1;
  double distance = 0;
  for (int i = 0; i < 1000; ++i) {
    std::vector<double> tau = evaluate<double>(gravity, {q}).front();
    for (std::size_t k = 0; k < q.size(); ++k) tau[k] += held.stiffness[k] * (held.goal[k] - q[k]);
    std::vector<std::vector<double>> arguments{q, qd, tau};
    if (implicit) arguments.push_back({1e-3});
    const auto qdd = evaluate<double>(forward, arguments).front();
    distance = 0;
    for (std::size_t k = 0; k < q.size(); ++k) {
      qd[k] += 1e-3 * qdd[k];
      q[k] += 1e-3 * qd[k];
      distance = std::max(distance, std::abs(q[k] - held.goal[k]));
      if (!std::isfinite(q[k]) || std::abs(q[k]) > 1e3) return 1e9;
    }
  }
  return distance;
}

Robot robot_from(const std::string& path) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(path, diagnostics);
  EXPECT_TRUE(robot);
  return robot.value();
}

/// UR10e with the rotors, damping and servo stiffness published with its model for MuJoCo
/// (mujoco_menagerie, universal_robots_ur10e/ur10e.xml): kg m^2, N m s/rad, N m/rad.
HeldRobot ur10e(bool rotors) {
  HeldRobot held{robot_from(TREELINE_ROBOTS_DIR "/ur10e/ur10e.urdf"), {}, {}, {}};
  held.scene.base = Base::fixed;
  const std::vector<std::string> names{"shoulder_pan", "shoulder_lift", "elbow",
                                       "wrist_1",      "wrist_2",       "wrist_3"};
  const double damping[] = {350, 350, 200, 30, 30, 30};
  held.stiffness = {4000, 4000, 3500, 3200, 3200, 3200};
  held.goal = {-1.5708, -1.5708, 1.5708, -1.5708, -1.5708, 0};  // its home
  for (std::size_t i = 0; i < names.size(); ++i) {
    held.scene.joint_friction[names[i]] = {damping[i], 0, 0};
    if (rotors) held.scene.armature[names[i]] = 0.1;
  }
  return held;
}

/// iiwa 14 with the gains published with its model for MuJoCo (mujoco_menagerie,
/// kuka_iiwa_14/iiwa14.xml: 2000 N m/rad, 200 N m s/rad, integrated implicitly) and the rotors of
/// Drake's URDF.
HeldRobot iiwa14(bool rotors) {
  HeldRobot held{robot_from(data_file("published/iiwa14_drake.urdf")), {}, {}, {}};
  held.scene.base = Base::fixed;
  for (const Joint& joint : held.robot.joints) {
    if (!info_of(joint.type).has_one_freedom()) continue;
    held.scene.joint_friction[joint.name] = {200, 0, 0};
    if (rotors) held.scene.armature[joint.name] = armature_of(joint);
  }
  held.stiffness.assign(7, 2000);
  held.goal = {0, 0.785398, 0, -1.5708, 0, 0, 0};  // its home
  return held;
}

// Measured: UR10e 3.4e-7 rad, iiwa 14 2.4e-6 rad. Both are overdamped: the slowest joints need
// damping / stiffness = 0.1 s for a factor of e.
TEST(ImplicitFriction, HoldsPublishedRobots) {
  EXPECT_LT(distance_after_a_second(ur10e(true), true), 1e-5);
  EXPECT_LT(distance_after_a_second(iiwa14(true), true), 1e-5);
}

// Without rotors the step is long: damping step / inertia at the last joints is 0.03 / 0.0002 and
// 0.2 / 0.001, where 2 is the border. Rotors suffice, and so does the implicit step.
TEST(ImplicitFriction, HoldsThemWithoutRotorsToo) {
  for (const auto& robot : {ur10e, iiwa14}) {
    EXPECT_GT(distance_after_a_second(robot(false), false), 1);
    EXPECT_LT(distance_after_a_second(robot(false), true), 1e-5);
    EXPECT_LT(distance_after_a_second(robot(true), false), 1e-5);
  }
}

}  // namespace
}  // namespace treeline::tests
