// Would catch: functions of the controller, which take sines as arguments and share what they
// compute, that differ from those of the contract; a joint's sine computed twice.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>
#include <regex>
#include <sstream>
#include <string>

#include "puma_arm.hpp"
#include "puma_arm_controller.h"

namespace puma_arm {
// Defined by the generated sources, declared in controller.cpp alone.
void controller_kinematics(const Real (&q)[6], const Real (&sin_q)[6], const Real (&cos_q)[6],
                           const Real (&qd)[6], Real (&position)[3], Real (&rotation)[9],
                           Real (&velocity)[6], Real (&g)[6]) noexcept;
void controller_joint_torque(const Real (&q)[6], const Real (&sin_q)[6], const Real (&cos_q)[6],
                             const Real (&qd)[6], const Real (&qdd)[6], Real (&tau)[6]) noexcept;
void controller_task_torque(const Real (&q)[6], const Real (&sin_q)[6], const Real (&cos_q)[6],
                            const Real (&qd)[6], const Real (&qdd_0)[6], const Real (&xdd_cmd)[6],
                            Real (&tau)[6]) noexcept;
void controller_push_torque(const Real (&q)[6], const Real (&sin_q)[6], const Real (&cos_q)[6],
                            const Real (&f_ext)[6], Real (&tau)[6]) noexcept;
}  // namespace puma_arm

namespace treeline::tests {
namespace {

struct ArmState {
  double q[6], sines[6], cosines[6], qd[6], qdd[6], xdd[6], force[6];
};

ArmState draw(std::mt19937& rng) {
  std::uniform_real_distribution<double> unit(-1, 1);
  ArmState state{};
  for (int i = 0; i < 6; ++i) {
    state.q[i] = 2.5 * unit(rng);
    state.sines[i] = std::sin(state.q[i]);
    state.cosines[i] = std::cos(state.q[i]);
    state.qd[i] = 3 * unit(rng);
    state.qdd[i] = 10 * unit(rng);
    state.xdd[i] = 10 * unit(rng);
    state.force[i] = 20 * unit(rng);
  }
  state.q[4] = 1 + 0.5 * unit(rng);  // away from the wrist's singularity
  state.sines[4] = std::sin(state.q[4]);
  state.cosines[4] = std::cos(state.q[4]);
  return state;
}

template <int size>
void expect_near(const double (&a)[size], const double (&b)[size], double tolerance) {
  for (int i = 0; i < size; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

TEST(ControllerFunctions, AreThoseOfTheContract) {
  std::mt19937 rng(5);
  for (int k = 0; k < 200; ++k) {
    const ArmState s = draw(rng);
    double p[3], R[9], v[6], g[6], tau[6], p_wanted[3], R_wanted[9], g_wanted[6], J[36],
        tau_wanted[6];
    puma_arm::controller_kinematics(s.q, s.sines, s.cosines, s.qd, p, R, v, g);
    puma_arm::forward_kinematics(s.q, p_wanted, R_wanted);
    puma_arm::gravity(s.q, g_wanted);
    puma_arm::jacobian(s.q, J);
    double v_wanted[6] = {};
    for (int i = 0; i < 36; ++i) v_wanted[i / 6] += J[i] * s.qd[i % 6];
    // Two orders of some hundred operations on numbers up to 100.
    expect_near(p, p_wanted, 1e-14);
    expect_near(R, R_wanted, 1e-14);
    expect_near(g, g_wanted, 1e-12);
    expect_near(v, v_wanted, 1e-13);
    puma_arm::controller_joint_torque(s.q, s.sines, s.cosines, s.qd, s.qdd, tau);
    puma_arm::inverse_dynamics(s.q, s.qd, s.qdd, tau_wanted);
    expect_near(tau, tau_wanted, 1e-11);
    double scale = 0;
    puma_arm::control_torque(s.q, s.qd, s.qdd, s.xdd, tau_wanted);
    for (const double each : tau_wanted) scale = std::fmax(scale, std::fabs(each));
    puma_arm::controller_task_torque(s.q, s.sines, s.cosines, s.qd, s.qdd, s.xdd, tau);
    expect_near(tau, tau_wanted, 1e-10 * (1 + scale));  // conditions of J up to 1e3
    puma_arm::controller_push_torque(s.q, s.sines, s.cosines, s.force, tau);
    for (int i = 0; i < 6; ++i) {
      double wanted = 0;
      for (int row = 0; row < 6; ++row) wanted -= J[6 * row + i] * s.force[row];
      EXPECT_NEAR(tau[i], wanted, 1e-12);
    }
  }
}

std::string read(const std::string& file) {
  std::ifstream stream(std::string(GENERATED) + "/" + file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

TEST(ControllerFunctions, AStepComputesEachSineOnce) {
  for (const char* file : {"controller_kinematics.cpp", "controller_joint_torque.cpp",
                           "controller_task_torque.cpp", "controller_push_torque.cpp"}) {
    const std::string text = read(file);
    ASSERT_FALSE(text.empty()) << file;
    EXPECT_EQ(text.find("sin_cos("), std::string::npos) << file;
  }
  const std::string step = read("controller.cpp") + read("controller_robot.hpp");
  const std::regex call("sin_cos\\(at->q,");
  EXPECT_EQ(
      std::distance(std::sregex_iterator(step.begin(), step.end(), call), std::sregex_iterator()),
      1);
}

}  // namespace
}  // namespace treeline::tests
