// Regressors and base parameters on random robots of every joint type. Would catch: columns in
// other frames, of other moments or in another order than the parameters of arguments; the gyration
// of a moment or the rate of a ball joint's axis that is missing; a dependency between parameters
// that is not found, or one that does not hold. The oracle is the interpreter on the robot as it is
// in the files: its inverse dynamics and energies for Y p and E p, and the rank of its columns at
// random states in 50 digits for the number of base parameters.
#include "interpreter/regressor.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "description/read_urdf.hpp"
#include "interpreter/physics.hpp"
#include "mechanism/build_mechanism.hpp"
#include "program/evaluate.hpp"
#include "recursion/base_parameters.hpp"
#include "recursion/energy_regressor.hpp"
#include "recursion/function_results.hpp"
#include "recursion/inverse_dynamics.hpp"
#include "recursion/seeded.hpp"
#include "recursion/trace_function.hpp"

namespace treeline::tests {
namespace {

namespace ip = interpreter;

using Digits = std::vector<Digits50>;
using Kind = ModelParameter::Kind;

std::vector<Seeded> robots() {
  std::vector<Seeded> all;
  const auto add = [&](RandomOptions options, int seeds) {
    for (int i = 0; i < seeds; ++i) all.push_back({900 + all.size(), options});
  };
  const JointMix hinges{1, 0, 0, 0, 0, 0};
  const JointMix slides{1, 0, 3, 0, 0, 0};
  add({.joints = 1, .mix = {1, 1, 1, 0, 1, 1, 1}, .aligned = 1}, 6);
  add({.joints = 3, .branching = 0, .mix = hinges, .aligned = 1}, 8);
  add({.joints = 4, .branching = 0, .mix = slides, .aligned = 1}, 8);
  add({.joints = 5, .branching = 0, .mix = hinges, .aligned = 0.7}, 4);
  add({.joints = 5, .branching = 0.4, .mix = slides, .aligned = 0.7}, 4);
  add({.joints = 6, .branching = 0.4, .locked = 0.2, .aligned = 0.8}, 4);
  add({.joints = 4, .branching = 0.4, .floating_base = true, .aligned = 0.8}, 3);
  add({.joints = 3, .branching = 0.2, .mix = {2, 0, 2, 1, 3, 3}, .aligned = 0.8}, 5);
  add({.joints = 3, .branching = 0.2, .mix = {1, 0, 2, 0, 0, 0, 4}, .aligned = 0.9}, 6);
  add({.joints = 4, .branching = 0.2, .mix = {1, 0, 1, 0, 0, 4, 0}, .aligned = 1}, 3);
  add({.joints = 5, .branching = 0.5, .mix = slides, .mimic = 0.6, .aligned = 1}, 8);
  add({.joints = 6, .branching = 0.3, .mimic = 0.6, .aligned = 0.8}, 4);
  add({.joints = 4, .branching = 0.5, .mix = hinges, .floating_base = true, .mimic = 0.6}, 2);
  return all;
}

/// A robot with the columns of all parameters, and those of rotors and friction.
class Regressor : public testing::TestWithParam<Seeded> {
 protected:
  explicit Regressor(bool rotors = true)
      : made_(random_mechanism(GetParam().seed, GetParam().options)) {
    made_.scene.regressor.rotors = rotors;
    made_.scene.regressor.friction = true;
    made_.scene.functions = {Function::inverse_dynamics_regressor, Function::energy_regressor};
    mechanism_ = mechanism_in_frames_of_files(made_.robot, made_.scene);
    columns_ = regressor_columns(mechanism_);
    model_ = model_from_robot<Digits50>(made_.robot, made_.scene);
    draw();
  }

  void draw() {
    q_ = random_position(dice_, model_);
    qd_ = random_entries<Digits50>(dice_, model_.nv, 4);
    qdd_ = random_entries<Digits50>(dice_, model_.nv, 20);
  }

  [[nodiscard]] int body_of(const ModelParameter& column) const {
    std::string link = column.owner;
    for (const Joint& joint : made_.robot.joints) {
      if (column.kind == Kind::inertial || joint.name != column.owner) continue;
      link = made_.robot.links[static_cast<std::size_t>(joint.child)].name;
    }
    int body = 0;
    while (model_.body(body).name != link) ++body;
    return body;
  }
  [[nodiscard]] std::vector<ip::UnitParameter> units(
      const std::vector<ModelParameter>& columns) const {
    std::vector<ip::UnitParameter> units;
    for (const ModelParameter& column : columns) {
      const auto kind = column.kind == Kind::inertial ? ip::UnitParameter::Kind::inertial
                        : column.kind == Kind::rotor  ? ip::UnitParameter::Kind::rotor
                                                      : ip::UnitParameter::Kind::viscous;
      units.push_back({kind, body_of(column), column.entry});
    }
    return units;
  }
  [[nodiscard]] Matrix50 interpreted(const std::vector<ModelParameter>& columns) const {
    return ip::inverse_dynamics_regressor<Digits50>(model_, units(columns), q_, qd_, qdd_);
  }
  /// Rows of several states.
  [[nodiscard]] Matrix50 stacked(const std::vector<ModelParameter>& columns) {
    const auto count = static_cast<Eigen::Index>(columns.size());
    const Eigen::Index states = count / model_.nv + 12;
    Matrix50 rows(states * model_.nv, count);
    for (Eigen::Index s = 0; s < states; ++s) {
      draw();
      rows.middleRows(s * model_.nv, model_.nv) = interpreted(columns);
    }
    return rows;
  }
  /// Of matter as in the file, with what is fixed to the links.
  [[nodiscard]] Vector50 parameters_of_file() const {
    Vector50 p = Vector50::Zero(static_cast<Eigen::Index>(columns_.size()));
    for (Eigen::Index k = 0; k < p.size(); ++k) {
      const ModelParameter& column = columns_[static_cast<std::size_t>(k)];
      if (column.kind == Kind::rotor) p(k) = model_.body(body_of(column)).armature;
      if (column.kind != Kind::inertial) continue;
      const Inertia& body = mechanism_.link_matter[column.frame];
      const ExactMatrix3 J = rotational_inertia(body);
      const Exact values[] = {body.mass, body.h(0), body.h(1), body.h(2), J(0, 0),
                              J(0, 1),   J(1, 1),   J(0, 2),   J(1, 2),   J(2, 2)};
      p(k) = values[column.entry];
    }
    return p;
  }

  RandomMechanism made_;
  Mechanism mechanism_;
  std::vector<ModelParameter> columns_;
  Model50 model_;
  Dice dice_{GetParam().seed + 7};
  Vector50 q_, qd_, qdd_;
};

INSTANTIATE_TEST_SUITE_P(Robots, Regressor, testing::ValuesIn(robots()));

TEST_P(Regressor, TimesParametersIsInverseDynamics) {
  const Vector50 p = parameters_of_file();
  const Vector50 tau = ip::inverse_dynamics<Digits50>(model_, q_, qd_, qdd_);
  EXPECT_LT(relative_error(Vector50(interpreted(columns_) * p), tau), kAlgebra);
}

TEST_P(Regressor, OfEnergiesTimesParametersIsEnergy) {
  const Vector50 p = parameters_of_file();
  const auto energies = [&] {
    const Matrix50 E = ip::energy_regressor<Digits50>(model_, units(columns_), q_, qd_);
    return Vector50(E * p);
  };
  const Vector50 first = energies();
  const Digits50 potential = ip::potential_energy<Digits50>(model_, q_);
  const Digits50 kinetic = ip::kinetic_energy<Digits50>(model_, q_, qd_);
  EXPECT_LT(abs(Digits50(first(0) - kinetic)), kAlgebra * (1 + kinetic));
  draw();  // what is fixed to the world adds a constant
  const Digits50 difference = ip::potential_energy<Digits50>(model_, q_) - potential;
  EXPECT_LT(abs(Digits50(energies()(1) - first(1) - difference)), Digits50("1e-32"));
}

// Column by column, the rate of the energies is the power of the joint forces.
TEST_P(Regressor, RateOfEnergyIsPower) {
  const auto parameters = units(columns_);
  const Vector50 rate = derivative([&](const Digits50& t) {
    const Matrix50 E = ip::energy_regressor<Digits50>(model_, parameters, moved(model_, q_, qd_, t),
                                                      qd_ + t * qdd_);
    return Vector50(E.colwise().sum().transpose());
  });
  Vector50 power = interpreted(columns_).transpose() * qd_;
  for (Eigen::Index k = 0; k < power.size(); ++k) {
    if (columns_[static_cast<std::size_t>(k)].kind == Kind::viscous) power(k) = 0;
  }
  EXPECT_LT(relative_error(rate, power), kDifference);
}

// Only a formula can be wrong: constants are not rounded. With the links' frames anywhere.
TEST_P(Regressor, RecursionsAgreeInFiftyDigits) {
  const Digits q = listed(q_), qd = listed(qd_), qdd = listed(qdd_);
  const auto Y = listed(interpreted(columns_));
  const auto E = listed(ip::energy_regressor<Digits50>(model_, units(columns_), q_, qd_));
  for (const Mechanism& mechanism : {mechanism_, reduced_mechanism(made_.robot, made_.scene)}) {
    const auto tree = tree_of<Digits50>(mechanism);
    const auto X = joint_transforms<Digits50>(tree, q);
    const auto by_recursion =
        inverse_dynamics_regressor<Digits50>(tree, X, {qd, qdd}, columns_).values();
    EXPECT_LT(relative_error(Results<Digits50>{by_recursion}, Results<Digits50>{Y}, 1), 1e-40);
    const auto energies = energy_regressor<Digits50>(tree, X, qd, columns_).values();
    EXPECT_LT(relative_error(Results<Digits50>{energies}, Results<Digits50>{E}, 1), 1e-40);
  }
}

TEST_P(Regressor, TracedFunctionsAgreeWithTheInterpreter) {
  const auto q = rounded_to<double>(listed(q_)), qd = rounded_to<double>(listed(qd_)),
             qdd = rounded_to<double>(listed(qdd_));
  const auto exact = [](const std::vector<double>& entries) {
    return Vector50(
        Eigen::Map<const Eigen::VectorXd>(entries.data(), static_cast<Eigen::Index>(entries.size()))
            .cast<Digits50>());
  };
  q_ = exact(q);
  qd_ = exact(qd);
  qdd_ = exact(qdd);
  const Results<Digits50> Y{listed(interpreted(columns_))};
  for (const Program& program :
       trace_function(mechanism_, Function::inverse_dynamics_regressor, 4)) {
    // Some roundings a link.
    EXPECT_LT(relative_error(evaluate<double>(program, {q, qd, qdd}), Y, 1), 1e-13);
  }
  const Results<Digits50> E{
      listed(ip::energy_regressor<Digits50>(model_, units(columns_), q_, qd_))};
  for (const Program& program : trace_function(mechanism_, Function::energy_regressor, 4)) {
    EXPECT_LT(relative_error(evaluate<double>(program, {q, qd}), E, 1), 1e-13);
  }
}

// The same parameters in the same frames and order: inverse dynamics that takes them as an argument
// gives Y p, for parameters that no body has.
TEST_P(Regressor, AreTheParametersOfArguments) {
  Scene scene = made_.scene;
  scene.armature.clear();
  Vector50 p = random_entries<Digits50>(dice_, static_cast<int>(columns_.size()), 1);
  for (const Link& link : made_.robot.links) scene.inputs.parameters.push_back({link.name});
  const Mechanism mechanism = reduced_mechanism(made_.robot, scene);
  ModelInputs<Digits50> inputs;
  for (const SceneInertia& link : scene.inputs.parameters) {
    Digits entries(kInertialParameters, Digits50(0));  // of links without columns
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (columns_[k].kind != Kind::inertial) p(static_cast<Eigen::Index>(k)) = 0;
      if (columns_[k].owner != link.link || columns_[k].kind != Kind::inertial) continue;
      entries[static_cast<std::size_t>(columns_[k].entry)] = p(static_cast<Eigen::Index>(k));
    }
    inputs.parameters.push_back(inertial_parameters(entries).front());
  }
  const auto tree = tree_of<Digits50>(mechanism, inputs);
  const Digits q = listed(q_), qd = listed(qd_), qdd = listed(qdd_);
  const auto X = joint_transforms<Digits50>(tree, q);
  const Results<Digits50> tau{inverse_dynamics<Digits50>(tree, X, {qd, qdd}, {})};
  const Results<Digits50> Yp{listed(Vector50(interpreted(columns_) * p))};
  EXPECT_LT(relative_error(Yp, tau, 1), 1e-38);
}

// No state has a column outside of the span of the base parameters' columns, and these are
// independent: a count that is too large or too small would show.
TEST_P(Regressor, HasTheRankOfItsBaseParameters) {
  const BaseParameters found = find_base_parameters(mechanism_, made_.scene.regressor);
  Matrix50 rows = stacked(columns_);
  for (Eigen::Index k = 0; k < rows.cols(); ++k) {
    const Digits50 length = rows.col(k).norm();
    if (length > Digits50("1e-30")) rows.col(k) /= length;  // else residue of cancellation
  }
  Eigen::FullPivLU<Matrix50> factor(rows);
  factor.setThreshold(Digits50("1e-30"));
  EXPECT_EQ(factor.rank(), static_cast<Eigen::Index>(found.base.size()));
}

// For parameters that no body has, so that each coefficient counts.
TEST_P(Regressor, OfBaseParametersTimesTheirValuesIsTheSame) {
  const BaseParameters found = find_base_parameters(mechanism_, made_.scene.regressor);
  ASSERT_EQ(found.parameters.size(), columns_.size());
  const Vector50 p = random_entries<Digits50>(dice_, static_cast<int>(columns_.size()), 1);
  std::vector<ModelParameter> columns;
  Vector50 values(static_cast<Eigen::Index>(found.base.size()));
  for (const BaseParameter& base : found.base) {
    EXPECT_EQ(base.combination.at(base.parameter), 1);
    Digits50 value = 0;
    for (const auto& [parameter, coefficient] : base.combination) {
      value += coefficient * p(static_cast<Eigen::Index>(parameter));
    }
    values(static_cast<Eigen::Index>(columns.size())) = value;
    columns.push_back(found.parameters[base.parameter]);
  }
  EXPECT_LT(
      relative_error(Vector50(interpreted(columns) * values), Vector50(interpreted(columns_) * p)),
      Digits50("1e-30"));
}

TEST_P(Regressor, HasNoColumnOfParametersWithoutEffect) {
  const BaseParameters found = find_base_parameters(mechanism_, made_.scene.regressor);
  const Matrix50 Y = interpreted(columns_);
  for (const std::size_t k : found.without_effect) {
    EXPECT_LT(Y.col(static_cast<Eigen::Index>(k)).norm(), Digits50("1e-35"))
        << name_of(columns_[k]);
  }
}

/// A serial arm of hinges, one metre apart along x, with these axes.
RandomMechanism arm(const std::vector<std::array<double, 3>>& axes) {
  RandomMechanism made;
  made.robot.links.push_back({"base", {}, 0});
  made.robot.root = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    Joint joint;
    joint.name = "joint" + std::to_string(i + 1);
    joint.type = JointType::revolute;
    joint.parent = static_cast<int>(i);
    joint.child = static_cast<int>(i) + 1;
    if (i > 0) joint.origin.xyz = {1, 0, 0};
    joint.axis = axes[i];
    made.robot.joints.push_back(joint);
    made.robot.links.push_back({"link" + std::to_string(i + 1), {}, 0});
  }
  return made;
}

std::vector<std::string> described(const RandomMechanism& made, const SceneRegressor& asked = {}) {
  const BaseParameters found = find_base_parameters(build_mechanism(made.robot, made.scene), asked);
  std::vector<std::string> texts;
  for (const BaseParameter& base : found.base) texts.push_back(describe(base, found));
  return texts;
}

// By hand: the elbow's mass hangs on the upper arm, and gravity acts on both.
TEST(BaseParameters, OfTwoHingesInAVerticalPlane) {
  const auto texts = described(arm({{0, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(texts,
            (std::vector<std::string>{"link1 mc_x + link2 m", "link1 mc_z", "link1 Iyy + link2 m",
                                      "link2 mc_x", "link2 mc_z", "link2 Iyy"}));
}

// By hand: with vertical axes no weight is felt. A rotor at the base turns with the link.
TEST(BaseParameters, OfTwoHingesInAHorizontalPlane) {
  SceneRegressor asked;
  asked.rotors = true;
  const auto texts = described(arm({{0, 0, 1}, {0, 0, 1}}), asked);
  EXPECT_EQ(texts, (std::vector<std::string>{"link1 Izz + link2 m + joint1 rotor", "link2 mc_x",
                                             "link2 mc_y", "link2 Izz", "joint2 rotor"}));
}

// With gravity as an argument, which may have any direction, weight is felt there too.
TEST(BaseParameters, FeelGravityThatIsAnArgument) {
  RandomMechanism made = arm({{0, 0, 1}});
  EXPECT_EQ(described(made), std::vector<std::string>{"link1 Izz"});
  made.scene.inputs.gravity = true;
  EXPECT_EQ(described(made), (std::vector<std::string>{"link1 mc_x", "link1 mc_y", "link1 Izz"}));
}

// By hand: of what the second link turns about the first axis, Ixx s^2 + Izz c^2 = Izz + (Ixx -
// Izz) s^2, where the mass of the third adds one to Izz, and another one from where the second axis
// is.
TEST(BaseParameters, OfAHingeAcrossAnother) {
  const auto texts = described(arm({{0, 0, 1}, {0, 1, 0}, {0, 0, 1}}));
  ASSERT_EQ(texts.size(), 15U);
  EXPECT_EQ(texts[0], "link1 Izz + link2 m + link2 Izz + 2 link3 m");
}

// Two fingers that always open alike: only the sum of their masses is felt in the motion.
TEST(BaseParameters, OfFingersThatMoveAlike) {
  RandomMechanism made;
  made.robot.links = {{"palm", {}, 0}, {"left", {}, 0}, {"right", {}, 0}};
  made.robot.root = 0;
  for (int i = 0; i < 2; ++i) {
    Joint joint;
    joint.name = i == 0 ? "left_joint" : "right_joint";
    joint.type = JointType::prismatic;
    joint.parent = 0;
    joint.child = i + 1;
    joint.axis = {i == 0 ? 1.0 : -1.0, 0, 0};
    if (i == 1) joint.mimic = Mimic{0, 1, 0};
    made.robot.joints.push_back(joint);
  }
  EXPECT_EQ(described(made), std::vector<std::string>{"left m + right m"});
  made.scene.gravity = {-9.81, 0, 0};  // lifts one and lowers the other
  EXPECT_EQ(described(made), (std::vector<std::string>{"left m", "right m"}));
}

// Counts of the literature: 36 for the PUMA 560 (Armstrong, Khatib & Burdick 1986 count them;
// Mayeda, Yoshida & Osuka 1990: 7 n - 4 for hinges, less 2 of the first axis along gravity).
TEST(BaseParameters, CountsOfTheLiterature) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(TREELINE_ROBOTS_DIR "/puma560/puma560.urdf", diagnostics);
  ASSERT_TRUE(robot);
  const Mechanism mechanism = build_mechanism(*robot, {});
  EXPECT_EQ(find_base_parameters(mechanism, {}).base.size(), 36U);
  SceneRegressor with_rotors;
  with_rotors.rotors = true;
  // Those of the first two joints cannot be told from Izz of links that turn about one axis only
  // (Khalil & Dombre, Modeling, Identification and Control of Robots, section 9.4).
  EXPECT_EQ(find_base_parameters(mechanism, with_rotors).base.size(), 40U);
}

}  // namespace
}  // namespace treeline::tests
