#include <algorithm>
#include <limits>

#include "tried_subjects.hpp"

// Functions of correct robots pass before they are written; a function with a fault planted into
// its graph does not. Would catch: a kind of function that is never tried, bounds so wide that
// faults pass, and correct functions that are refused.

namespace treeline::tests {
namespace {

/// Multiplies every entry of the program's results by `factor`.
void spoil(Program& program, double factor) {
  const Graph::Scope scope(program.graph);
  for (Result& result : program.results) {
    for (Expression& value : result.values) value = value * Expression(factor);
  }
}

std::vector<std::string> spoil_all(std::vector<GeneratedFunction>& functions, double factor) {
  std::vector<std::string> names;
  for (GeneratedFunction& generated : functions) {
    spoil(generated.program, factor);
    names.push_back(source_stem(generated));
  }
  return names;
}

/// Expects that nothing fails as generated, and that every function fails if it is off by one part
/// in 1e8 (float: 1e2), also if only the batch functions are.
void expect_tried(const Subjects& subjects) {
  EXPECT_EQ(failing(subjects, subjects.generation), std::vector<std::string>{});
  const double factor = subjects.scene.real == Real::float32 ? 1 + 1e-2 : 1 + 1e-8;
  Generation plain = subjects.generation;
  std::vector<std::string> spoilt = spoil_all(plain.functions, factor);
  // The damped law is composed of other functions.
  if (plain.damped) spoilt.emplace_back("damped_control_torque");
  EXPECT_EQ(failing(subjects, plain), spoilt);
  Generation batch = subjects.generation;
  spoilt = spoil_all(batch.batch, factor);
  EXPECT_EQ(failing(subjects, batch), spoilt);
}

TEST(TryFunctions, OfAnArm) {
  expect_tried(load("puma560"));
}

TEST(TryFunctions, InFloat) {
  expect_tried(load("puma560", "scene_float.yaml"));
}

TEST(TryFunctions, OfAllKinds) {
  RandomOptions options;
  options.joints = 3;
  options.floating_base = true;
  RandomMechanism drawn = random_mechanism(3, options);
  Scene& scene = drawn.scene;
  scene.batch = 4;
  scene.damped = EffectiveMassLimit{20, 0.5};
  scene.contacts = {scene.operational_points.front()};
  scene.contacts.front().rows = {true, true, true, false, false, false};
  scene.contacts.front().axes = Axes::world;
  scene.functions.assign(kSceneFunctions.begin(), kSceneFunctions.end());
  std::erase_if(scene.functions, needs_objects);
  std::erase_if(scene.functions, needs_constraints);
  expect_tried({drawn.robot, scene, generate(drawn.robot, scene)});
}

TEST(TryFunctions, OfARobotThatStands) {
  expect_tried(load("humanoid24", "scene_stand.yaml"));
}

TEST(TryFunctions, OfObjects) {
  Subjects subjects = load("humanoid24", "scene_box.yaml");
  subjects.scene.functions = {kObjectFunctions.begin(), kObjectFunctions.end()};
  subjects.generation = generate(subjects.robot, subjects.scene);
  expect_tried(subjects);
}

// Reduced from bullet3's minitaur with all joints fixed: its legs balance up to 1e-16 m. Would
// catch that counting as 0 beside the radius of gyration: gravity's torque has no other terms.
TEST(TryFunctions, OfABodyThatBalancesButForNoise) {
  const Subjects subjects = read(
      "<link name='body'><inertial><origin xyz='-8.7157417e-10 2.8262e-16 -0.00030504'/>"
      "<mass value='6'/><inertia ixx='27.03' ixy='0' ixz='6.7e-5' iyy='27.16' iyz='0' "
      "izz='27.13'/></inertial></link>",
      "base: floating\n"
      "operational_points: [{name: body, link: body, rows: [x, y, z, rx, ry, rz]}]\n"
      "functions: [inverse_dynamics, gravity, nonlinear_effects, mass_matrix, forward_dynamics, "
      "lambda_inverse, control_torque]\n");
  EXPECT_EQ(failing(subjects, subjects.generation), std::vector<std::string>{});
}

constexpr const char* kBody =
    "<inertial><origin xyz='0.02 -0.01 0.1'/><mass value='0.4'/><inertia ixx='0.002' ixy='0' "
    "ixz='0' iyy='0.003' iyz='0' izz='0.0025'/></inertial>";

std::string one_joint(const std::string& type, const std::string& origin) {
  return std::string("<link name='base'/><link name='arm'>") + kBody +
         "</link><joint name='first' type='" + type + "'><origin xyz='" + origin +
         "'/><parent link='base'/><child link='arm'/></joint>";
}

// Would catch sizes of a contact from levers of joints alone: a disc that turns about its centre
// has none, and what is finite was called infinite.
TEST(TryFunctions, OfADiscWhoseCentreRests) {
  for (const char* origin : {"0.2 0 0", "0.2 0 0.3"}) {
    const Subjects subjects =
        read(one_joint("continuous", origin),
             "constraints: [{name: rim, between: [arm, world], rolling: {radius: 0.1, axis: [0, 1, "
             "0]}}]\n"
             "functions: [constrained_forward_dynamics, constraint_jacobian, constraint_errors]\n");
    EXPECT_EQ(failing(subjects, subjects.generation), std::vector<std::string>{}) << origin;
  }
}

// Would catch rows of a ball joint judged in one pose, where x cannot move, and a border whose
// power is 0 in float: 0 / 0.
TEST(TryFunctions, OfABallJointWithMoreRowsThanFreedoms) {
  for (const char* real : {"float", "double"}) {
    const Subjects subjects =
        read(one_joint("ball", "0 0 0.2"),
             std::string("real: ") + real +
                 "\noperational_points:\n"
                 "  - {name: tip, link: arm, origin: {xyz: [0.1, 0, 0]}, rows: [x, y, z]}\n"
                 "  - {name: hub, link: arm, rows: [x, y, z]}\n"
                 "functions: [lambda, control_torque, null_space_projector]\n");
    EXPECT_EQ(failing(subjects, subjects.generation), std::vector<std::string>{}) << real;
  }
}

// Reduced from the iris of example-robot-data. Its rotors have limits of 1e16 rad.
TEST(TryFunctions, OfARotorWhoseLimitsMeanNone) {
  const Subjects subjects = read(
      "<link name='body'><inertial><mass value='2'/><inertia ixx='0.1' ixy='0' ixz='0' iyy='0.2' "
      "iyz='0' izz='0.15'/></inertial></link><link name='rotor'><inertial><mass value='0.1'/>"
      "<inertia ixx='0.001' ixy='0' ixz='0' iyy='0.01' iyz='0' izz='0.011'/></inertial></link>"
      "<joint name='spin' type='revolute'><origin xyz='0.1 0 0.3'/><parent link='body'/>"
      "<child link='rotor'/><axis xyz='0 0 1'/>"
      "<limit lower='-1e16' upper='1e16' effort='0' velocity='0'/></joint>",
      "base: floating\n");
  EXPECT_EQ(failing(subjects, subjects.generation), std::vector<std::string>{});
}

// Like the neck of example-robot-data's icub: M is singular in some poses, by a branch that no
// task is on. A faulty lambda is found all the same.
TEST(TryFunctions, OfATaskBesideAGimbal) {
  const auto joint = [](const std::string& name, const std::string& parent,
                        const std::string& child, const std::string& axis, const char* at) {
    return "<joint name='" + name + "' type='continuous'><origin xyz='" + at + "'/><parent link='" +
           parent + "'/><child link='" + child + "'/><axis xyz='" + axis + "'/></joint>";
  };
  const auto link = [](const std::string& name) {
    return "<link name='" + name +
           "'><inertial><origin xyz='0.02 0.01 0.2'/><mass value='2'/><inertia ixx='0.1' iyy='0.2' "
           "izz='0.15' ixy='0.01' ixz='0' iyz='0'/></inertial></link>";
  };
  const Subjects subjects =
      read(link("torso") + link("upper") + link("fore") + link("head") +
               "<link name='outer'/><link name='inner'/>" +
               joint("shoulder", "torso", "upper", "0 1 0", "0.1 0 0.3") +
               joint("elbow", "upper", "fore", "1 0 0", "0.1 0 0.3") +
               joint("yaw", "torso", "outer", "0 0 1", "0 0 0") +
               joint("nod", "outer", "inner", "1 0 0", "0 0 0") +
               joint("turn", "inner", "head", "0 0 1", "0 0 0"),
           "base: floating\noperational_points: [{name: hand, link: fore, rows: [x, y, z]}]\n"
           "functions: [lambda_inverse, lambda, control_torque]\n");
  EXPECT_EQ(failing(subjects, subjects.generation), std::vector<std::string>{});
  Generation spoilt = subjects.generation;
  const auto names = spoil_all(spoilt.functions, 1 + 1e-8);
  EXPECT_EQ(failing(subjects, spoilt), names);
}

// NaN is the largest error of all. In the neutral state q[0] is 0.
TEST(TryFunctions, SeeWhatIsNotFinite) {
  const Subjects subjects = load("planar3r");
  Generation spoilt = subjects.generation;
  Program& program = spoilt.functions.front().program;
  const Graph::Scope scope(program.graph);
  for (Result& result : program.results) {
    for (Expression& value : result.values) {
      const Expression q = program.graph.input("q[0]");
      value = value * (sin(q) / q);
    }
  }
  const auto failed = try_functions(subjects.robot, subjects.scene, spoilt);
  ASSERT_EQ(failed.size(), 1U);
  EXPECT_EQ(failed.front().state.kind, StateClass::neutral);
  EXPECT_EQ(failed.front().error, std::numeric_limits<double>::infinity());
}

/// Multiplies every entry of the results by 0 / 0 if q[0] is 0, and otherwise by 1 up to rounding.
void lose_at_zero(Program& program) {
  const Graph::Scope scope(program.graph);
  const Expression q = program.graph.input("q[0]");
  const Expression one = (Expression(2) * q + q * (q * q)) / (q * (Expression(2) + q * q));
  for (Result& result : program.results) {
    for (Expression& value : result.values) value = value * one;
  }
}

// Would catch: a singular task, for which there is no reference, that hides a NaN.
TEST(TryFunctions, SeeWhatIsNotFiniteWhereTheTaskIsSingular) {
  Subjects subjects = load("planar3r");
  for (GeneratedFunction& generated : subjects.generation.functions) {
    if (generated.function == Function::lambda) lose_at_zero(generated.program);
  }
  EXPECT_EQ(failing(subjects, subjects.generation), std::vector<std::string>{"lambda"});
}

// Results of `singular: exact` at a singularity are never a failure.
TEST(TryFunctions, AskForNothingOfABareSolve) {
  Subjects subjects = load("planar3r");
  subjects.scene.singular = SingularTasks::exact;
  subjects.generation = generate(subjects.robot, subjects.scene);
  EXPECT_EQ(failing(subjects, subjects.generation), std::vector<std::string>{});
}

TEST(TryFunctions, AtStatesOfEveryClass) {
  for (const StateClass kind : kStateClasses) {
    EXPECT_TRUE(std::any_of(kTrialStates.begin(), kTrialStates.end(), [&](int index) {
      return class_of_state(index) == kind;
    })) << state_class_name(kind);
  }
  EXPECT_LT(*std::max_element(kTrialStates.begin(), kTrialStates.end()), TrialOptions().confirm);
}

// The residue of CAD programs in an offset of zero is removed from the code but remains in the
// file. Would catch: a Jacobian that is refused because of a lever arm of 2e-16 m that it does not
// have.
TEST(TryFunctions, MeasureLeversOfNoiseByTheRobot) {
  const std::string body =
      "<inertial><origin xyz='0.02 0.01 0.2'/><mass value='2'/>"
      "<inertia ixx='0.1' iyy='0.2' izz='0.15' ixy='0.01' ixz='0' iyz='0'/></inertial>";
  std::string text = "<robot name='wrist'><link name='l0'>" + body + "</link>";
  const std::vector<std::string> origins = {"0 0 0.3", "0.4 0 0.1", "1.2e-16 -1.6e-16 0"};
  for (std::size_t i = 0; i < origins.size(); ++i) {
    const std::string own = std::to_string(i + 1);
    text += "<link name='l" + own + "'>" + body + "</link><joint name='j" + own +
            "' type='continuous'><parent link='l" + std::to_string(i) + "'/><child link='l" + own +
            "'/><origin xyz='" + origins[i] + "'/><axis xyz='" + (i % 2 == 0 ? "0 0 1" : "0 1 0") +
            "'/></joint>";
  }
  Diagnostics diagnostics;
  const auto robot = parse_urdf(text + "</robot>", "wrist.urdf", diagnostics);
  ASSERT_TRUE(robot);
  for (const char* base : {"fixed", "floating"}) {
    const auto scene = parse_scene(std::string("name: wrist\nbase: ") + base +
                                       "\noperational_points: [{name: tip, link: l3}]\n",
                                   "wrist.yaml", *robot, diagnostics);
    ASSERT_TRUE(scene);
    const Subjects subjects{*robot, *scene, generate(*robot, *scene)};
    EXPECT_EQ(failing(subjects, subjects.generation), std::vector<std::string>{}) << base;
  }
}

TEST(TryFunctions, OfRandomRobots) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    RandomOptions options;
    options.floating_base = seed % 3 == 0;
    options.mimic = seed % 2 == 0 ? 0.3 : 0;
    options.external_forces = 1;
    options.mix.planar = 1;
    if (seed % 3 == 2) options.mix.ball = 5;
    const Subjects subjects = draw(seed, options, seed % 4 == 0 ? Real::float32 : Real::float64);
    EXPECT_EQ(failing(subjects, subjects.generation), std::vector<std::string>{})
        << "seed " << seed;
  }
}

}  // namespace
}  // namespace treeline::tests
