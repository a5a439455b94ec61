#include "data/list_data.hpp"
#include "fixture.hpp"

// Ball joints from the file to the compiled code. Would catch: a quaternion that is drawn, named,
// passed or packed into lanes in another order than it is read, and a function that is not
// generated or not right for a robot with ball joints.

namespace treeline::tests {
namespace {

/// A humanoid with ball joints at hips and shoulders, in a scene.
Subjects ball_humanoid(const std::string& scene_text) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(data_file("written/ball_humanoid.urdf"), diagnostics);
  if (!robot) throw std::runtime_error("the robot cannot be read");
  const auto scene = parse_scene(scene_text, "scene.yaml", *robot, diagnostics);
  if (!scene) throw std::runtime_error("the scene cannot be read");
  return {*robot, *scene, generate(*robot, *scene)};
}

void expect_right(const Subjects& subjects, std::size_t functions, int states) {
  const auto report = check_or_throw(subjects, quick_options(states));
  EXPECT_TRUE(report.passed()) << print_text(report);
  EXPECT_EQ(report.functions.size(), functions);
}

TEST(BallCheck, HumanoidThatFloats) {
  expect_right(ball_humanoid(R"(
base: floating
operational_points:
  - {name: left_hand, link: left_forearm, origin: {xyz: [0, 0, -0.24]}}
  - {name: right_foot, link: right_foot, axes: local}
contacts:
  - {name: toe, link: left_foot, origin: {xyz: [0.12, 0, -0.07]}}
functions: [forward_kinematics, jacobian, bias_acceleration, inverse_dynamics, gravity,
            nonlinear_effects, mass_matrix, forward_dynamics, lambda_inverse, lambda,
            control_torque, contact_motion, contact_inverse_inertia, effective_mass,
            impulse_response]
)"),
               15, 24);
}

TEST(BallCheck, FunctionsOnRequest) {
  expect_right(ball_humanoid(R"(
base: fixed
functions: [center_of_mass, center_of_mass_jacobian, inverse_dynamics_derivatives,
            forward_dynamics_derivatives, coriolis_matrix, kinetic_energy, potential_energy,
            link_inverse_inertias, centroidal_momentum_matrix, centroidal_momentum, centroidal_bias,
            center_of_mass_bias_acceleration, subtree_masses_and_centers,
            kinetic_energy_derivatives, centroidal_momentum_derivatives,
            centroidal_momentum_rate_derivatives]
)"),
               16, 24);
}

TEST(BallCheck, HandsThatHoldAnObject) {
  expect_right(ball_humanoid(R"(
base: fixed
operational_points:
  - {name: left_hand, link: left_forearm, origin: {xyz: [0, 0, -0.24]}}
  - {name: right_hand, link: right_forearm, origin: {xyz: [0, 0, -0.24]}}
objects:
  - name: box
    mass: 3
    inertia: {ixx: 0.05, iyy: 0.04, izz: 0.06}
    grasps:
      - {point: left_hand, origin: {xyz: [0, -0.2, 0]}}
      - {point: right_hand, origin: {xyz: [0, 0.2, 0]}}
functions: [object_state, object_control_torque, object_forward_dynamics]
)"),
               3, 24);
}

TEST(BallCheck, FloatInBatches) {
  expect_right(ball_humanoid(R"(
base: floating
real: float
batch: 8
functions: [inverse_dynamics, mass_matrix, forward_dynamics]
)"),
               6, 20);
}

TEST(BallCheck, PlainScalars) {
  expect_right(ball_humanoid(R"(
base: fixed
lanes: 1
sin_cos: given
functions: [inverse_dynamics, mass_matrix, forward_dynamics]
)"),
               3, 20);
}

TEST(BallCheck, RandomRobots) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    RandomOptions options;
    options.joints = 3 + static_cast<int>(seed);
    options.floating_base = seed % 2 == 0;
    options.mimic = seed % 3 == 0 ? 0.4 : 0;
    options.mix = {3, 1, 2, 1, 0, 1, 5};
    options.external_forces = static_cast<int>(seed % 3);
    const Subjects subjects = draw(seed, options, seed % 4 == 3 ? Real::float32 : Real::float64);
    const auto report = check_or_throw(subjects, quick_options(40));
    EXPECT_TRUE(report.passed()) << "seed " << seed << "\n" << print_text(report);
  }
}

}  // namespace
}  // namespace treeline::tests
