#include <gtest/gtest.h>

#include "mechanism/build_mechanism.hpp"
#include "mechanism/find_limbs.hpp"
#include "oracle/model_from_robot.hpp"
#include "program/evaluate.hpp"
#include "recursion/function_results.hpp"
#include "recursion/methods/centroidal_momentum.hpp"
#include "recursion/routes/trace_function.hpp"
#include "recursion/seeded.hpp"
#include "recursion/tree/deferred_rotations.hpp"

// Momentum about the centre of mass and the matter of subtrees on reduced mechanisms, compared with
// the interpreter for the robot as written in the files. Would catch: momentum that regrouping
// changes, a wrong link from which the centre is seen, rotors that count as links, a mimic joint
// without its multiplier, and masses of base parameters taken for those of the file.

namespace treeline::tests {
namespace {

namespace ip = interpreter;

std::vector<Seeded> centroidal_robots() {
  std::vector<Seeded> all;
  const auto add = [&](RandomOptions options, int seeds) {
    for (int i = 0; i < seeds; ++i) all.push_back({1100 + all.size(), options});
  };
  add({.joints = 1}, 3);
  add({.joints = 7, .branching = 0}, 3);
  add({.joints = 8, .branching = 0.4, .locked = 0.2}, 4);
  add({.joints = 8, .branching = 0.4, .floating_base = true, .massless = 0.3}, 4);
  add({.joints = 8, .branching = 0.4, .mimic = 0.4, .locked = 0.1}, 4);
  add({.joints = 6, .branching = 0.3, .mimic = 0.2, .rotors = 0.7}, 3);
  add({.joints = 6, .branching = 0.3, .floating_base = true, .rotors = 0.7}, 3);
  add({.joints = 5, .branching = 0.2, .mix = {2, 0, 1, 1, 1, 4}}, 5);     // planar
  add({.joints = 5, .branching = 0.2, .mix = {2, 0, 2, 1, 3, 3}}, 4);     // floating joints within
  add({.joints = 6, .branching = 0.2, .mix = {3, 1, 2, 1, 1, 1, 5}}, 5);  // balls
  add({.joints = 4, .branching = 0.3, .mix = {2, 0, 1, 1, 0, 0, 5}, .floating_base = true}, 3);
  return all;
}

constexpr std::array kCentroidalFunctions = {
    Function::centroidal_momentum_matrix, Function::centroidal_momentum, Function::centroidal_bias,
    Function::center_of_mass_bias_acceleration, Function::subtree_masses_and_centers};

using Digits = std::vector<Digits50>;

class Centroidal : public testing::TestWithParam<Seeded> {
 protected:
  Centroidal()
      : made_(random_mechanism(GetParam().seed, GetParam().options)),
        mechanism_(reduced_mechanism(made_.robot, made_.scene)),
        model_(model_from_robot<Digits50>(made_.robot, made_.scene)) {
    Rng rng(GetParam().seed + 7);
    q_ = random_position(rng, model_);
    qd_ = random_entries<Digits50>(rng, model_.nv, 4);
  }

  [[nodiscard]] Results<Digits50> expected(Function function) const {
    switch (function) {
      case Function::centroidal_momentum_matrix:
        return {listed(ip::centroidal_momentum_matrix<Digits50>(model_, q_))};
      case Function::centroidal_momentum:
        return {listed(ip::centroidal_momentum<Digits50>(model_, q_, qd_))};
      case Function::centroidal_bias:
        return {listed(ip::centroidal_bias<Digits50>(model_, q_, qd_))};
      case Function::center_of_mass_bias_acceleration:
        return {listed(ip::center_of_mass_bias_acceleration<Digits50>(model_, q_, qd_))};
      default:
        return expected_subtrees();
    }
  }

  [[nodiscard]] Results<Digits50> expected_subtrees() const {
    const auto all = ip::subtrees<Digits50>(model_, q_);
    Results<Digits50> results(2);
    for (int i = 0; i < model_.size(); ++i) {
      if (model_.body(i).kind == ip::JointKind::fixed) continue;
      results[0].push_back(all[static_cast<std::size_t>(i)].mass);
      for (const Digits50& x : all[static_cast<std::size_t>(i)].center) results[1].push_back(x);
    }
    return results;
  }

  /// By the recursions as they stand, with the constants unrounded.
  [[nodiscard]] Results<Digits50> recursion(Function function, const Mechanism& mechanism) const {
    auto tree = tree_of<Digits50>(mechanism);
    auto X = joint_transforms<Digits50>(tree, listed(q_));
    defer_rotations(tree, X);
    const Digits qd = listed(qd_);
    const auto six = [](const Wrench<Digits50>& w) {
      return Results<Digits50>{{w.f.x, w.f.y, w.f.z, w.n.x, w.n.y, w.n.z}};
    };
    switch (function) {
      case Function::centroidal_momentum_matrix:
        return {centroidal_momentum_matrix(tree, X).values()};
      case Function::centroidal_momentum:
        return six(centroidal_momentum<Digits50>(tree, X, qd));
      case Function::centroidal_bias:
        return six(centroidal_bias<Digits50>(tree, X, qd));
      case Function::center_of_mass_bias_acceleration: {
        const auto a = center_of_mass_bias_acceleration<Digits50>(tree, X, qd);
        return {{a.x, a.y, a.z}};
      }
      default:
        break;
    }
    Results<Digits50> results(2);
    for (const auto& [mass, center] : subtree_matter(tree, X)) {
      results[0].push_back(mass);
      results[1].insert(results[1].end(), {center.x, center.y, center.z});
    }
    return results;
  }

  RandomMechanism made_;
  Mechanism mechanism_;
  ip::Model<Digits50> model_;
  ip::Vector<Digits50> q_, qd_;
};

class FloatingCentroidal : public Centroidal {};

std::vector<Seeded> floating_centroidal_robots() {
  std::vector<Seeded> floating = centroidal_robots();
  std::erase_if(floating, [](const Seeded& robot) { return !robot.options.floating_base; });
  return floating;
}

INSTANTIATE_TEST_SUITE_P(Robots, Centroidal, testing::ValuesIn(centroidal_robots()));
INSTANTIATE_TEST_SUITE_P(Robots, FloatingCentroidal,
                         testing::ValuesIn(floating_centroidal_robots()));

// Only a formula can be wrong; with all joints turned late and with none, regrouped and not.
TEST_P(Centroidal, RecursionsAgreeInFiftyDigits) {
  Mechanism late = mechanism_;
  for (MovingLink& link : late.links) {
    link.defers_rotation = link.carries_column = link.has_one_coordinate();
  }
  const Mechanism kept = build_mechanism(made_.robot, made_.scene);
  for (const Mechanism* mechanism : std::array<const Mechanism*, 3>{&mechanism_, &late, &kept}) {
    for (const Function function : kCentroidalFunctions) {
      EXPECT_LT(relative_error(recursion(function, *mechanism), expected(function), 1), 1e-40)
          << function_name(function);
    }
  }
}

// With limbs in lanes and without.
TEST_P(Centroidal, TracedFunctionsAgreeWithTheInterpreter) {
  Mechanism in_lanes = mechanism_;
  in_lanes.limbs = find_limbs(mechanism_, 8);
  for (const Mechanism& mechanism : {mechanism_, in_lanes}) {
    for (const Function function : kCentroidalFunctions) {
      for (const Program& program : trace_function(mechanism, function)) {
        std::vector<std::vector<double>> arguments{rounded_to<double>(listed(q_))};
        if (takes(function, Quantity::qd)) arguments.push_back(rounded_to<double>(listed(qd_)));
        const auto results = evaluate<double>(program, arguments);
        // A few roundings per link, and rounded arguments.
        EXPECT_LT(relative_error(results, expected(function), 1), 1e-12) << program.name;
      }
    }
  }
}

// Where a floating base is does not matter, so no digits are lost there.
TEST_P(FloatingCentroidal, MomentumDoesNotFeelThePlace) {
  std::vector<double> near = rounded_to<double>(listed(q_));
  std::vector<double> far = near;
  for (std::size_t i = 0; i < 3; ++i) far[i] *= 1e9;
  for (const Function function : {Function::centroidal_momentum_matrix,
                                  Function::centroidal_momentum, Function::centroidal_bias}) {
    const Program program = trace_function(mechanism_, function).front();
    std::vector<std::vector<double>> arguments{near};
    if (takes(function, Quantity::qd)) arguments.push_back(rounded_to<double>(listed(qd_)));
    const auto here = evaluate<double>(program, arguments);
    arguments[0] = far;
    EXPECT_EQ(evaluate<double>(program, arguments), here) << program.name;
  }
}

}  // namespace
}  // namespace treeline::tests
