// Regressors and base parameters on random robots of every joint type. Would catch: columns in
// other frames, of other moments or in another order than the parameters of arguments; the gyration
// of a moment or the rate of a ball joint's axis that is missing; Coulomb friction of another width
// than the scene's, a payload about another origin; a rotor or friction of a joint that follows
// another without a column, or at the wrong multiple; a dependency between parameters that is not
// found, or one that does not hold. The oracle is the interpreter on the robot as it is
// in the files: its inverse dynamics and energies for Y p and E p, and the rank of its columns at
// random states in 50 digits for the number of base parameters.
#include "interpreter/regressor.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "description/scene_queries.hpp"
#include "interpreter/physics.hpp"
#include "mechanism/build_mechanism.hpp"
#include "mechanism/digits50_from_file.hpp"
#include "program/evaluate.hpp"
#include "recursion/function_results.hpp"
#include "recursion/methods/energy_regressor.hpp"
#include "recursion/methods/inverse_dynamics.hpp"
#include "recursion/parameters/base_parameters.hpp"
#include "recursion/routes/trace_function.hpp"
#include "recursion/seeded.hpp"

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
  const RandomOptions followers{.joints = 7,
                                .branching = 0.4,
                                .mix = {3, 1, 2, 0.3, 0.3, 0.5, 0.5},
                                .mimic = 0.7,
                                .aligned = 0.8,
                                .rotors = 0.7,
                                .varied_mimics = true};
  add(followers, 8);
  RandomOptions floating = followers;
  floating.floating_base = true;
  add(floating, 2);
  return all;
}

/// A robot with the columns of all parameters, and those of rotors and friction.
class Regressor : public testing::TestWithParam<Seeded> {
 protected:
  explicit Regressor(bool rotors = true)
      : made_(random_mechanism(GetParam().seed, GetParam().options)) {
    made_.scene.regressor.rotors = rotors;
    made_.scene.regressor.friction = made_.scene.regressor.coulomb = true;
    made_.scene.regressor.width = 0.3;
    add_friction();
    made_.scene.functions = {Function::inverse_dynamics_regressor, Function::energy_regressor};
    mechanism_ = mechanism_in_frames_of_files(made_.robot, made_.scene);
    columns_ = regressor_columns(mechanism_);
    model_ = model_from_robot<Digits50>(made_.robot, made_.scene);
    draw();
  }

  /// Whether it turns or slides, by a coordinate of its own or of another.
  [[nodiscard]] bool has_column(const Joint& joint) const {
    const Joint* leader = &joint;
    while (leader->mimic) leader = &made_.robot.joints[detail::at(leader->mimic->joint)];
    return info_of(joint.type).has_one_freedom() && !made_.scene.locked.contains(leader->name);
  }

  /// Gives friction to every second joint that has a column.
  void add_friction() {
    bool every_second = false;
    for (const Joint& joint : made_.robot.joints) {
      if (!has_column(joint)) continue;
      every_second = !every_second;
      if (!every_second) continue;
      made_.scene.joint_friction[joint.name] = {rng_.rounded(0.1, 2), rng_.rounded(0.1, 2),
                                                rng_.rounded(0.1, 0.5)};
      if (joint.mimic && rng_.chance(0.5)) made_.scene.joint_friction[joint.name].width = 0.3;
    }
  }

  void draw() {
    q_ = random_position(rng_, model_);
    qd_ = random_entries<Digits50>(rng_, model_.nv, 4);
    qdd_ = random_entries<Digits50>(rng_, model_.nv, 20);
  }

  [[nodiscard]] int body_of(const ModelParameter& column) const {
    std::string link = column.owner;
    for (const Joint& joint : made_.robot.joints) {
      if (column.is_of_body() || joint.name != column.owner) continue;
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
      const auto kind = column.is_of_body()            ? ip::UnitParameter::Kind::inertial
                        : column.kind == Kind::rotor   ? ip::UnitParameter::Kind::rotor
                        : column.kind == Kind::viscous ? ip::UnitParameter::Kind::viscous
                                                       : ip::UnitParameter::Kind::coulomb;
      const auto own = made_.scene.joint_friction.find(column.owner);
      units.push_back({kind, body_of(column), column.entry,
                       own == made_.scene.joint_friction.end() ? 0.3 : own->second.width});
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
  /// Parameters of matter as in the file, with what is fixed to the links.
  [[nodiscard]] Vector50 parameters_of_file() const {
    Vector50 p = Vector50::Zero(static_cast<Eigen::Index>(columns_.size()));
    for (Eigen::Index k = 0; k < p.size(); ++k) {
      const ModelParameter& column = columns_[static_cast<std::size_t>(k)];
      if (column.kind == Kind::rotor) p(k) = model_.body(body_of(column)).armature;
      if (column.kind == Kind::viscous) p(k) = model_.body(body_of(column)).damping;
      if (column.kind == Kind::coulomb) p(k) = model_.body(body_of(column)).friction;
      if (column.kind != Kind::inertial) continue;
      const Inertia& body = mechanism_.link_matter[column.frame];
      const Digits50Matrix3 J = rotational_inertia(body);
      const Digits50 values[] = {body.mass, body.h(0), body.h(1), body.h(2), J(0, 0),
                                 J(0, 1),   J(1, 1),   J(0, 2),   J(1, 2),   J(2, 2)};
      p(k) = values[column.entry];
    }
    return p;
  }

  RandomMechanism made_;
  Mechanism mechanism_;
  std::vector<ModelParameter> columns_;
  Model50 model_;
  Rng rng_{GetParam().seed + 7};
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
    const Kind kind = columns_[static_cast<std::size_t>(k)].kind;
    if (kind == Kind::viscous || kind == Kind::coulomb) power(k) = 0;
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
  scene.joint_friction.clear();
  Vector50 p = random_entries<Digits50>(rng_, static_cast<int>(columns_.size()), 1);
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

/// The ten parameters of a body whose moments are about its centre.
Vector50 ten_parameters(const Inertial& body) {
  const Inertia inertia = digits50_inertia(body);
  const Digits50Matrix3 J = rotational_inertia(inertia);
  Vector50 ten(kInertialParameters);
  ten << inertia.mass, inertia.h, J(0, 0), J(0, 1), J(1, 1), J(0, 2), J(1, 2), J(2, 2);
  return ten;
}

// What a body fixed to any link, also to one that is fixed to another, adds to the joint forces.
// Other columns can be left out.
TEST_P(Regressor, OfAPayloadIsWhatItAdds) {
  Scene scene = made_.scene;
  scene.regressor = {};
  scene.regressor.none = true;
  Robot with_payload = made_.robot;
  const Inertial body = detail::random_inertial(rng_, 0.3);
  for (int link = static_cast<int>(made_.robot.links.size()); link-- > 0;) {
    const std::string& name = made_.robot.links[static_cast<std::size_t>(link)].name;
    if (find_freedoms_of_link(made_.robot, scene, name).empty()) continue;
    scene.regressor.payloads = {name};
    Joint joint;
    joint.name = "to_payload";
    joint.type = JointType::fixed;
    joint.parent = link;
    joint.child = static_cast<int>(with_payload.links.size());
    with_payload.links.push_back({"payload", body, 0});
    with_payload.joints.push_back(joint);
    break;
  }
  const auto tau = [&](const Robot& robot) {
    return ip::inverse_dynamics<Digits50>(model_from_robot<Digits50>(robot, scene), q_, qd_, qdd_);
  };
  const Vector50 added = tau(with_payload) - tau(made_.robot);
  const Mechanism mechanism = mechanism_in_frames_of_files(made_.robot, scene);
  const auto columns = regressor_columns(mechanism);
  ASSERT_EQ(columns.size(), 10U);
  EXPECT_EQ(name_of(columns[1]), "payload of " + scene.regressor.payloads[0] + " mc_x");
  EXPECT_LT(relative_error(Vector50(interpreted(columns) * ten_parameters(body)), added), kAlgebra);
  const auto tree = tree_of<Digits50>(mechanism);
  const Digits q = listed(q_), qd = listed(qd_), qdd = listed(qdd_);
  const auto X = joint_transforms<Digits50>(tree, q);
  const Results<Digits50> Y{
      inverse_dynamics_regressor<Digits50>(tree, X, {qd, qdd}, columns).values()};
  EXPECT_LT(relative_error(Y, Results<Digits50>{listed(interpreted(columns))}, 1), 1e-40);
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
  const Vector50 p = random_entries<Digits50>(rng_, static_cast<int>(columns_.size()), 1);
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

}  // namespace
}  // namespace treeline::tests
