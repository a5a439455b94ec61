// Rotors as bodies of their own. Would catch: a rotor on the wrong link or about the wrong axis,
// one that turns the wrong way or at the wrong ratio, an inertia that counts twice, and a function
// that misses the rotor's coupling or its gyroscopic moment. The oracles: a URDF that has the
// rotors as links behind joints that mimic; and by hand, a flywheel on a turntable.
#include <gtest/gtest.h>

#include "description/with_rotors.hpp"
#include "mechanism/build_mechanism.hpp"
#include "recursion/function_results.hpp"
#include "recursion/seeded.hpp"
#include "recursion/template_results.hpp"

namespace treeline::tests {
namespace {

/// A robot whose scene has rotors, and the same with links in the file that somebody wrote by hand:
/// another link frame, turned about the axis and moved along it, which nothing feels.
struct Rotored {
  Robot robot, written;
  Scene scene, plain;
};

Rotored rotored(std::uint64_t seed) {
  RandomOptions options;
  options.joints = 6;
  options.branching = 0.3;
  options.mix = {4, 1, 2, 0.5, 0, 0, 0};
  options.floating_base = seed % 3 == 0;
  options.aligned = 1;  // axes of one entry: a a^T of others is rounded
  RandomMechanism made = random_mechanism(seed, options);
  Rotored result{made.robot, made.robot, made.scene, made.scene};
  Rng rng(seed);
  bool other_link = false;
  const std::size_t joints = made.robot.joints.size();
  for (std::size_t j = 0; j < joints; ++j) {
    const Joint& driven = made.robot.joints[j];
    if (!info_of(driven.type).has_one_freedom()) continue;
    SceneRotor rotor{rng.rounded(0.001, 0.01), rng.rounded(-20, 20), "", std::nullopt};
    other_link = !other_link;
    Joint joint;
    joint.name = "spin" + std::to_string(j);
    joint.type = JointType::continuous;
    joint.parent = driven.parent;
    joint.origin = driven.origin;
    joint.axis = driven.axis;
    if (other_link) {
      rotor.link = made.robot.links[static_cast<std::size_t>(made.robot.root)].name;
      rotor.axis = std::array<double, 3>{0, 1, 0};
      joint.parent = made.robot.root;
      joint.origin = {{0.1, 0.2, 0.3}, {}};
      joint.axis = *rotor.axis;
    }
    joint.child = static_cast<int>(result.written.links.size());
    joint.mimic = Mimic{static_cast<int>(j), rotor.ratio, 0.7};
    Inertial inertial;
    const auto& a = joint.axis;
    inertial.ixx = rotor.inertia * a[0] * a[0];
    inertial.iyy = rotor.inertia * a[1] * a[1];
    inertial.izz = rotor.inertia * a[2] * a[2];
    result.written.links.push_back({joint.name, inertial, 0});
    result.written.joints.push_back(joint);
    result.scene.rotors[driven.name] = rotor;
  }
  return result;
}

TEST(GyroscopicRotors, AreLinksBehindJointsThatMimic) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const Rotored made = rotored(seed);
    const Oracle<Digits50> oracle(made.written, made.plain);
    Rng rng(seed + 3);
    const auto in = rounded_to<Digits50>(rounded_to<double>(oracle.random_inputs(rng)));
    const Yardstick size = yardstick(oracle, in);
    const Mechanism mechanism = reduced_mechanism(made.robot, made.scene);
    const TemplateRun<Digits50> run(mechanism, in);
    for (const Function function :
         {Function::inverse_dynamics, Function::gravity, Function::nonlinear_effects,
          Function::mass_matrix, Function::forward_dynamics, Function::lambda_inverse,
          Function::coriolis_matrix, Function::kinetic_energy}) {
      const auto expected = oracle.results(function, in);
      for (const auto& [route, results] : run.results(function)) {
        EXPECT_LT(relative_error(results, expected, size.least_scale(function)),
                  1e-36 * size.growth(function))
            << function_name(function) << " " << route;
      }
    }
  }
}

// The angles of rotors, large as they are, are not computed.
TEST(GyroscopicRotors, TakeNoSinesOfTheirOwn) {
  const Rotored made = rotored(2);
  const auto count = [](const Mechanism& mechanism) {
    int sines = 0;
    const std::vector<double> q(static_cast<std::size_t>(mechanism.nq()), 0.5);
    for (const auto& step : joint_transforms<double>(tree_of<double>(mechanism), q)) {
      if (step.turn.s != 0) ++sines;
    }
    return sines;
  };
  EXPECT_EQ(count(reduced_mechanism(made.robot, made.scene)),
            count(reduced_mechanism(made.robot, made.plain)));
  EXPECT_GT(count(reduced_mechanism(made.written, made.plain)),
            count(reduced_mechanism(made.robot, made.plain)));
}

// A turntable about z, 2 kg m^2, with a frame that tilts about y, 0.5 kg m^2 about y and 0.3 about
// x and z, whose motor's rotor, 0.01 kg m^2 about y, sits on the turntable and turns 30 times as
// fast the other way. By Lagrange with rates a of the table and b of the tilt: T = (2 + 0.3) a^2 /
// 2 + 0.5 b^2 / 2 + 0.01 (30 b)^2 / 2: about y the table does not turn, so there is no coupling;
// with the rotor about z, 0.01 (a - 30 b)^2 / 2.
TEST(GyroscopicRotors, OfATurntable) {
  Robot robot;
  robot.links = {{"base", {}, 0}, {"table", {}, 0}, {"frame", {}, 0}};
  robot.root = 0;
  Inertial table, frame;
  table.mass = frame.mass = 1;
  table.ixx = table.iyy = 1.5;
  table.izz = 2;
  frame.ixx = frame.izz = 0.3;
  frame.iyy = 0.5;
  robot.links[1].inertial = table;
  robot.links[2].inertial = frame;
  for (int i = 0; i < 2; ++i) {
    Joint joint;
    joint.name = i == 0 ? "turn" : "tilt";
    joint.type = JointType::continuous;
    joint.parent = i;
    joint.child = i + 1;
    joint.axis = {0, i == 0 ? 0.0 : 1.0, i == 0 ? 1.0 : 0.0};
    robot.joints.push_back(joint);
  }
  for (const bool upright : {false, true}) {
    Scene scene;
    scene.rotors["tilt"] = {0.01, -30, "", std::nullopt};
    if (upright) {
      scene.rotors["tilt"].link = "table";
      scene.rotors["tilt"].axis = std::array<double, 3>{0, 0, 1};
    }
    const Mechanism mechanism = reduced_mechanism(robot, scene);
    const Inputs<double> in{{0.4, 1.1}, {2, 3}, {5, 7}, {0, 0}, {}, {}};
    const TemplateRun<double> run(mechanism, in);
    const auto M = run.results(Function::mass_matrix).front().results.front();
    EXPECT_NEAR(M[0], 2.3 + (upright ? 0.01 : 0), 1e-13);
    EXPECT_NEAR(M[1], upright ? -0.3 : 0, 1e-13);
    EXPECT_NEAR(M[3], 0.5 + 9, 1e-13);
    const auto tau = run.results(Function::inverse_dynamics).front().results.front();
    EXPECT_NEAR(tau[0], M[0] * 5 + M[1] * 7, 1e-12);
    EXPECT_NEAR(tau[1], M[1] * 5 + M[3] * 7, 1e-12);
  }
}

}  // namespace
}  // namespace treeline::tests
