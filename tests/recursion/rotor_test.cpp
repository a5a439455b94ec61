// Would catch: a rotor that weighs, that turns with the links before its joint, or that is left out
// of one of the functions; the other files of this folder compare rotors on random robots with the
// interpreter.
#include <gtest/gtest.h>

#include <cmath>

#include "data/list_data.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "interpreter/instances.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline::tests {
namespace {

using V = interpreter::Vector<double>;

Robot parsed_robot(const std::string& urdf) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(urdf, "r.urdf", diagnostics);
  EXPECT_TRUE(robot);
  return robot.value();
}

/// A point mass m = 2 kg at 0.5 m on a joint about the horizontal y axis of a cart along x, 3 kg.
const char* const kCart =
    "<robot name='cart'><link name='rail'/>"
    "<link name='cart'><inertial><mass value='3'/>"
    "<inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link>"
    "<link name='bob'><inertial><origin xyz='0 0 -0.5'/><mass value='2'/>"
    "<inertia ixx='0' ixy='0' ixz='0' iyy='0' iyz='0' izz='0'/></inertial></link>"
    "<joint name='slide' type='prismatic'><parent link='rail'/><child link='cart'/>"
    "<axis xyz='1 0 0'/><limit lower='-9' upper='9' effort='9' velocity='9'/></joint>"
    "<joint name='swing' type='continuous'><parent link='cart'/><child link='bob'/>"
    "<axis xyz='0 1 0'/></joint></robot>";

/// M, b + g of the cart by Lagrange, with rotors of 4 kg and 0.25 kg m^2 at the joints.
struct Lagrange {
  double M[2][2], h[2];
};
Lagrange lagrange(double angle, double rate) {
  const double m = 2, l = 0.5, g = 9.81, s = std::sin(angle), c = std::cos(angle);
  return {{{3 + m + 4, -m * l * c}, {-m * l * c, m * l * l + 0.25}},
          {m * l * s * rate * rate, m * g * l * s}};
}

TEST(Rotors, AddToTheirJointsAlone) {
  const Robot robot = parsed_robot(kCart);
  Scene scene;
  scene.armature = {{"slide", 4}, {"swing", 0.25}};
  const auto model = model_from_robot<double>(robot, scene);
  for (const double angle : {-2.0, 0.0, 0.7, 3.0}) {
    const V q = V::Map(std::array{0.3, angle}.data(), 2),
            qd = V::Map(std::array{1.5, -2.5}.data(), 2);
    const V qdd = V::Map(std::array{0.6, 4.0}.data(), 2);
    const Lagrange expected = lagrange(angle, qd(1));
    const auto M = interpreter::mass_matrix<double>(model, q);
    const V tau = interpreter::inverse_dynamics<double>(model, q, qd, qdd);
    for (int i = 0; i < 2; ++i) {
      double force = expected.h[i];
      for (int j = 0; j < 2; ++j) {
        EXPECT_NEAR(M(i, j), expected.M[i][j], 1e-14);
        force += expected.M[i][j] * qdd(j);
      }
      EXPECT_NEAR(tau(i), force, 1e-13);
    }
    EXPECT_LT((interpreter::forward_dynamics<double>(model, q, qd, tau) - qdd).norm(), 1e-13);
    EXPECT_NEAR(interpreter::kinetic_energy<double>(model, q, qd), qd.dot(M * qd) / 2, 1e-14);
  }
}

Scene franka_scene(bool rotors) {
  Scene scene;
  scene.base = Base::fixed;
  if (!rotors) return scene;
  for (int i = 1; i <= 7; ++i) {  // as published with the robot's model for MuJoCo, kg m^2
    scene.armature["fr3_joint" + std::to_string(i)] = i <= 4 ? 0.195 : 0.074;
  }
  return scene;
}

/// The largest distance from the goal, rad, after a second of joint impedance at 1 kHz with the
/// gains of Franka's own example, from 0.1 rad off in every joint.
double distance_after_a_second(bool rotors) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(data_file("published/fr3.urdf"), diagnostics);
  EXPECT_TRUE(robot);
  const auto model = model_from_robot<double>(*robot, franka_scene(rotors));
  const double stiffness[] = {600, 600, 600, 600, 250, 150, 50};
  const double damping[] = {50, 50, 50, 50, 30, 25, 15};
  V goal = V::Zero(model.nv), qd = V::Zero(model.nv);
  goal.head<7>() << 0, -0.785, 0, -2.356, 0, 1.571, 0.785;
  V q = goal;
  q.head<7>().array() += 0.1;
  for (int step = 0; step < 1000 && q.allFinite(); ++step) {
    V tau = interpreter::gravity<double>(model, q);
    for (int i = 0; i < 7; ++i) tau(i) += stiffness[i] * (goal(i) - q(i)) - damping[i] * qd(i);
    qd += 1e-3 * interpreter::forward_dynamics<double>(model, q, qd, tau);
    q += 1e-3 * qd;
  }
  return q.allFinite() ? (q - goal).head<7>().cwiseAbs().maxCoeff() : 1e9;
}

TEST(Rotors, KeepAnImpedanceLoopStable) {
  EXPECT_LT(distance_after_a_second(true), 0.02);
  EXPECT_GT(distance_after_a_second(false), 1);
}

}  // namespace
}  // namespace treeline::tests
