// Rotors, regressors, energies and momentum compared with figures that Pinocchio computed in long
// double (`record_quantities`): the interpreter in 50 digits and the generated program. Would
// catch: another order or sign of inertial parameters, another frame of a regressor's columns, a
// momentum about another point or in other axes, a rotor that counts twice or in the wrong place.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "data/list_data.hpp"
#include "generation/generate_code.hpp"
#include "interpreter/golden.hpp"
#include "oracle/graph_run.hpp"
#include "oracle/interpret.hpp"

namespace treeline::tests {
namespace {

using Json = nlohmann::json;
using Digits50 = interpreter::Digits50;
/// Results of each function, one after another, in our order.
using Figures = std::map<Function, std::vector<double>>;

/// Reads what Pinocchio's order of joints is converted by.
class Reader {
 public:
  Reader(const GoldenOrder& order, bool floats) : v_(order.v) {
    for (const int v : order.v) {
      if (!floats || v == 0) joints_.push_back(floats ? 0 : v);
      if (floats && v >= 6) joints_.push_back(v - 5);
    }
  }

  [[nodiscard]] std::vector<double> vector(const Json& json) const {
    return picked(json.get<std::vector<double>>(), v_);
  }
  /// Columns of velocities, all rows.
  [[nodiscard]] std::vector<double> columns(const Json& json) const {
    std::vector<double> all;
    for (const Json& row : json) append(vector(row), all);
    return all;
  }
  [[nodiscard]] std::vector<double> square(const Json& json) const {
    std::vector<double> all;
    for (const int v : v_) append(vector(json.at(static_cast<std::size_t>(v))), all);
    return all;
  }
  /// Ten columns a joint; rows of velocities if `by_velocity`.
  [[nodiscard]] std::vector<double> parameters(const Json& json, bool by_velocity) const {
    std::vector<int> places;
    for (const int joint : joints_) {
      for (int k = 0; k < 10; ++k) places.push_back(10 * joint + k);
    }
    std::vector<double> all;
    for (std::size_t i = 0; i < json.size(); ++i) {
      const Json& row = json.at(by_velocity ? static_cast<std::size_t>(v_.at(i)) : i);
      append(picked(row.get<std::vector<double>>(), places), all);
    }
    return all;
  }
  static void append(const std::vector<double>& from, std::vector<double>& to) {
    to.insert(to.end(), from.begin(), from.end());
  }

 private:
  static std::vector<double> picked(const std::vector<double>& from, const std::vector<int>& at) {
    std::vector<double> to;
    for (const int i : at) to.push_back(from.at(static_cast<std::size_t>(i)));
    return to;
  }

  std::vector<int> v_, joints_;  ///< of each of our velocities and moving links
};

Figures figures_with_rotors(const Json& json, const Reader& read) {
  return {{Function::inverse_dynamics, read.vector(json.at("rnea"))},
          {Function::forward_dynamics, read.vector(json.at("aba"))},
          {Function::mass_matrix, read.square(json.at("M"))},
          {Function::kinetic_energy, {json.at("kinetic").get<double>()}},
          {Function::potential_energy, {json.at("potential").get<double>()}}};
}

Figures figures_without_rotors(const Json& json, const Reader& read) {
  const std::vector<double> A_G = read.columns(json.at("A_G"));
  std::vector<double> momentum = read.columns(json.at("h_by_q"));
  Reader::append(A_G, momentum);
  std::vector<double> rate = read.columns(json.at("rate_by_q"));
  Reader::append(read.columns(json.at("rate_by_v")), rate);
  Reader::append(A_G, rate);
  return {{Function::inverse_dynamics_regressor, read.parameters(json.at("Y"), true)},
          {Function::energy_regressor, read.parameters(json.at("E"), false)},
          {Function::centroidal_momentum_matrix, A_G},
          {Function::centroidal_momentum, json.at("h_G").get<std::vector<double>>()},
          {Function::centroidal_bias, json.at("bias").get<std::vector<double>>()},
          {Function::centroidal_momentum_derivatives, momentum},
          {Function::centroidal_momentum_rate_derivatives, rate}};
}

std::vector<double> values(const DoubleVector& v) {
  return {v.data(), v.data() + v.size()};
}

State state_of(const GoldenState& golden) {
  State state;
  state.q = values(golden.q);
  state.qd = values(golden.qd);
  state.qdd = values(golden.qdd);
  state.tau = values(golden.tau);
  return state;
}

/// Largest difference over the largest figure.
template <class T>
double error(const std::vector<T>& actual, const std::vector<double>& expected) {
  EXPECT_EQ(actual.size(), expected.size());
  double worst = 0;
  double largest = 0;
  for (std::size_t i = 0; i < std::min(actual.size(), expected.size()); ++i) {
    worst = std::max(worst, std::abs(static_cast<double>(actual[i] - T(expected[i]))));
    largest = std::max(largest, std::abs(expected[i]));
  }
  return worst / largest;
}

/// The figures are doubles of results in long double, whose inputs are doubles. A fixed base's
/// momentum cancels up to two digits. Generated code rounds at each operation.
constexpr double kExact = 1e-14;
constexpr double kDouble = 1e-12;

/// A robot in a scene, and what is generated for the functions of `figures`.
class Compared {
 public:
  Compared(const Robot& robot, Scene scene, const Figures& figures) {
    for (const auto& [function, expected] : figures) scene.functions.push_back(function);
    Diagnostics diagnostics;
    auto generation = generate_code(robot, scene, {"robot.urdf", "", "", ""}, diagnostics);
    if (!generation) throw std::runtime_error(to_string(diagnostics.list().front()));
    generation_ = std::move(*generation);
    subject_ = make_subject<Digits50>(robot, scene, &generation_.mechanism);
  }

  void compare(const State& state, const Figures& figures) const {
    for (const GeneratedFunction& generated : generation_.functions) {
      const std::vector<double>& expected = figures.at(generated.function);
      const std::string name = function_name(generated.function);
      EXPECT_LE(error(interpret<Digits50>(generated.function, subject_, state), expected), kExact)
          << name;
      EXPECT_LE(error(GraphRun(generated.program).results(state, Real::float64), expected), kDouble)
          << name;
    }
  }

 private:
  Generation generation_;
  Subject<Digits50> subject_;
};

class GoldenQuantities : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Robots, GoldenQuantities, testing::Values("puma560", "panda", "solo12"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST_P(GoldenQuantities, ArePinocchios) {
  GoldenRobot golden = read_golden(GetParam());
  // Pinocchio leaves out matter that is fixed to the world, which here counts for the centre of
  // mass.
  if (golden.scene.base == Base::fixed) {
    golden.robot.links.at(static_cast<std::size_t>(golden.robot.root)).inertial.reset();
  }
  const Reader read(golden.order, golden.scene.base == Base::floating);
  std::ifstream file(data_file(std::string("golden/") + GetParam() + "_quantities.json"));
  const Json json = Json::parse(file);
  Scene plain = golden.scene;
  plain.functions.clear();
  Scene geared = plain;
  geared.armature = json.at("armature").get<std::map<std::string, double>>();
  const Json& states = json.at("states");
  ASSERT_EQ(states.size(), 3U);
  const Compared with_rotors(golden.robot, geared, figures_with_rotors(states.at(0), read));
  const Compared without(golden.robot, plain, figures_without_rotors(states.at(0), read));
  for (const Json& each : states) {
    const State state = state_of(golden.states.at(each.at("state").get<std::size_t>()));
    with_rotors.compare(state, figures_with_rotors(each, read));
    without.compare(state, figures_without_rotors(each, read));
  }
}

}  // namespace
}  // namespace treeline::tests
