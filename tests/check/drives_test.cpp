#include "fixture.hpp"

// Rotors, friction and springs from the scene to the compiled code. Would catch: a term that one
// function leaves out, a scale of errors that does not know a term, an input `step` that is not
// passed, and a function of a language or a batch that computes friction in another way.

namespace treeline::tests {
namespace {

/// Gives every joint of one degree a rotor, friction and a spring, none of them alike.
void add_drives(const Robot& robot, Scene& scene, bool coulomb) {
  double size = 1;
  for (const Joint& joint : robot.joints) {
    if (!info_of(joint.type).has_one_freedom()) continue;
    scene.armature[joint.name] = 0.1 * size;
    scene.joint_friction[joint.name] = {2 * size, coulomb ? 3 * size : 0, 0.05 * size};
    scene.joint_springs[joint.name] = {20 * size, 0.3 * size};
    size *= 0.9;
  }
}

void expect_right(Subjects subjects, int states = 40) {
  subjects.generation = generate(subjects.robot, subjects.scene);
  const auto report = check_or_throw(subjects, quick_options(states));
  EXPECT_TRUE(report.passed()) << print_text(report);
  const std::size_t forms = subjects.scene.batch > 0 ? 2 : 1;
  EXPECT_EQ(report.functions.size(), forms * subjects.scene.functions.size());
}

const std::vector<Function> kOfArm = {Function::inverse_dynamics,
                                      Function::gravity,
                                      Function::nonlinear_effects,
                                      Function::mass_matrix,
                                      Function::forward_dynamics,
                                      Function::lambda,
                                      Function::control_torque,
                                      Function::inverse_dynamics_derivatives,
                                      Function::forward_dynamics_derivatives,
                                      Function::coriolis_matrix,
                                      Function::kinetic_energy,
                                      Function::potential_energy,
                                      Function::operational_bias_force,
                                      Function::operational_gravity};

TEST(DrivesCheck, EveryFunctionOfAnArm) {
  for (const Real real : {Real::float64, Real::float32}) {
    for (const bool coulomb : {false, true}) {
      Subjects subjects = load("puma560");
      subjects.scene.real = real;
      subjects.scene.functions = kOfArm;
      add_drives(subjects.robot, subjects.scene, coulomb);
      expect_right(subjects);
    }
  }
}

TEST(DrivesCheck, FrictionAtTheEndOfAStep) {
  for (const Real real : {Real::float64, Real::float32}) {
    Subjects subjects = load("puma560");
    subjects.scene.real = real;
    subjects.scene.functions = {Function::forward_dynamics};
    add_drives(subjects.robot, subjects.scene, true);
    subjects.scene.implicit_friction = true;
    expect_right(subjects);
  }
}

TEST(DrivesCheck, InC) {
  Subjects subjects = load("puma560");
  subjects.scene.language = Language::c;
  subjects.scene.lanes = 1;
  subjects.scene.functions = {Function::inverse_dynamics, Function::forward_dynamics};
  add_drives(subjects.robot, subjects.scene, true);
  subjects.scene.implicit_friction = true;
  expect_right(subjects);
}

TEST(DrivesCheck, Batches) {
  Subjects subjects = load("puma560");
  subjects.scene.batch = 4;
  subjects.scene.functions = {Function::inverse_dynamics, Function::forward_dynamics};
  add_drives(subjects.robot, subjects.scene, true);
  subjects.scene.implicit_friction = true;
  expect_right(subjects);
}

TEST(DrivesCheck, RotorsOfTheirOwn) {
  Subjects subjects = load("puma560");
  subjects.scene.functions = kOfArm;
  double ratio = 3;
  for (const Joint& joint : subjects.robot.joints) {
    if (!info_of(joint.type).has_one_freedom()) continue;
    subjects.scene.rotors[joint.name] = {0.001, ratio *= -1.5, "", std::nullopt};
  }
  expect_right(subjects);
}

TEST(DrivesCheck, ConstraintsAtTheEndOfAStep) {
  Subjects subjects = load("humanoid24", "scene_stand.yaml");
  subjects.scene.functions = {Function::constrained_forward_dynamics};
  add_drives(subjects.robot, subjects.scene, true);
  subjects.scene.implicit_friction = true;
  expect_right(subjects, 20);
}

TEST(DrivesCheck, HandsAndFeet) {
  for (const char* scene : {"scene_box.yaml", "scene_stand.yaml"}) {
    SCOPED_TRACE(scene);
    Subjects subjects = load("humanoid24", scene);
    add_drives(subjects.robot, subjects.scene, true);
    expect_right(subjects, 20);
  }
}

}  // namespace
}  // namespace treeline::tests
