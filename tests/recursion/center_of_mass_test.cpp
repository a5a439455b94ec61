#include "recursion/methods/center_of_mass.hpp"

#include <gtest/gtest.h>

#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "program/evaluate.hpp"
#include "recursion/function_results.hpp"
#include "recursion/routes/trace_function.hpp"
#include "recursion/seeded.hpp"

// The centre of mass and its Jacobian of reduced mechanisms, compared with the interpreter for the
// robot as written in the files. Would catch: matter that regrouping loses at the fixed base or
// counts twice, a mimic joint without its multiplier, and links of a planar or floating joint in
// the wrong axes.

namespace treeline::tests {
namespace {

constexpr std::array kCenterOfMassFunctions = {Function::center_of_mass,
                                               Function::center_of_mass_jacobian};

std::vector<Seeded> center_of_mass_robots() {
  std::vector<Seeded> all;
  const auto add = [&](RandomOptions options, int seeds) {
    for (int i = 0; i < seeds; ++i) all.push_back({300 + all.size(), options});
  };
  add({.joints = 1}, 4);
  add({.joints = 7, .branching = 0}, 4);
  add({.joints = 8, .branching = 0.4, .locked = 0.2}, 6);
  add({.joints = 8, .branching = 0.4, .floating_base = true}, 4);
  add({.joints = 8, .branching = 0.4, .mimic = 0.4, .locked = 0.1}, 6);
  add({.joints = 6, .branching = 0.3, .mimic = 0.2, .rotors = 0.7}, 3);
  add({.joints = 6, .branching = 0.2, .mix = {5, 1, 2, 1, 2, 2}}, 6);
  add({.joints = 6, .branching = 0.2, .mix = {3, 1, 2, 1, 1, 1, 5}}, 6);
  return all;
}

/// Largest difference relative to the largest expected entry, or to 1.
template <class A>
double error_of(const std::vector<A>& actual, const std::vector<Digits50>& expected) {
  EXPECT_EQ(actual.size(), expected.size());
  Digits50 largest = 1;
  Digits50 worst = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    largest = std::max<Digits50>(largest, abs(expected[i]));
    worst = std::max<Digits50>(worst, abs(Digits50(actual[i]) - expected[i]));
  }
  return static_cast<double>(Digits50(worst / largest));
}

class CenterOfMass : public testing::TestWithParam<Seeded> {
 protected:
  CenterOfMass()
      : made_(random_mechanism(GetParam().seed, GetParam().options)),
        mechanism_(reduced_mechanism(made_.robot, made_.scene)),
        model_(model_from_robot<Digits50>(made_.robot, made_.scene)) {
    Rng rng(GetParam().seed + 7);
    q_ = random_position(rng, model_);
  }

  [[nodiscard]] std::vector<Digits50> expected(Function function) const {
    return function == Function::center_of_mass
               ? listed(interpreter::center_of_mass<Digits50>(model_, q_))
               : listed(interpreter::center_of_mass_jacobian<Digits50>(model_, q_));
  }

  RandomMechanism made_;
  Mechanism mechanism_;
  interpreter::Model<Digits50> model_;
  interpreter::Vector<Digits50> q_;
};

INSTANTIATE_TEST_SUITE_P(Robots, CenterOfMass, testing::ValuesIn(center_of_mass_robots()));

TEST_P(CenterOfMass, TracedFunctionsAgreeWithTheInterpreter) {
  for (const Function function : kCenterOfMassFunctions) {
    for (const Program& program : trace_function(mechanism_, function)) {
      const auto results = evaluate<double>(program, {rounded_to<double>(listed(q_))});
      // A few roundings per link, and rounded coordinates.
      EXPECT_LT(error_of(results[0], expected(function)), 1e-13) << program.name;
    }
  }
}

// Constants are not rounded, so only a formula can be wrong.
TEST_P(CenterOfMass, RecursionsAgreeInFiftyDigits) {
  const auto tree = tree_of<Digits50>(mechanism_);
  const std::vector<Digits50> q = listed(q_);
  const auto X = joint_transforms<Digits50>(tree, q);
  const auto center = center_of_mass(tree, X);
  EXPECT_LT(error_of(std::vector<Digits50>{center.x, center.y, center.z},
                     expected(Function::center_of_mass)),
            1e-40);
  EXPECT_LT(error_of(center_of_mass_jacobian(tree, X).values(),
                     expected(Function::center_of_mass_jacobian)),
            1e-40);
}

}  // namespace
}  // namespace treeline::tests
