#include <gtest/gtest.h>

#include "interpreter/physics.hpp"
#include "mechanism/build_mechanism.hpp"
#include "mechanism/find_limbs.hpp"
#include "program/evaluate.hpp"
#include "recursion/function_results.hpp"
#include "recursion/methods/coriolis_matrix.hpp"
#include "recursion/methods/kinetic_energy.hpp"
#include "recursion/methods/mass_matrix.hpp"
#include "recursion/methods/potential_energy.hpp"
#include "recursion/routes/trace_function.hpp"
#include "recursion/seeded.hpp"

// Coriolis matrix and energies on reduced mechanisms against the interpreter on the robot as it is
// in the files, and against their definitions. Would catch: a C that takes velocities to the right
// forces but leaves no skew matrix, or another than the Christoffel symbols give; terms of a moving
// floating joint or of a mimic joint that are missing; energy that regrouping loses.

namespace treeline::tests {
namespace {

namespace ip = interpreter;

std::vector<Seeded> coriolis_robots() {
  std::vector<Seeded> all;
  const auto add = [&](RandomOptions options, int seeds) {
    for (int i = 0; i < seeds; ++i) all.push_back({700 + all.size(), options});
  };
  add({.joints = 1}, 3);
  add({.joints = 6, .branching = 0}, 3);
  add({.joints = 7, .branching = 0.4, .locked = 0.2}, 3);
  add({.joints = 6, .branching = 0.4, .floating_base = true}, 3);
  add({.joints = 7, .branching = 0.4, .mimic = 0.5, .locked = 0.1}, 4);
  add({.joints = 6, .branching = 0.3, .mimic = 0.2, .rotors = 0.7}, 3);
  add({.joints = 6, .branching = 0.4, .floating_base = true, .mimic = 0.5}, 2);
  add({.joints = 4, .branching = 0.2, .mix = {2, 0, 2, 1, 3, 3}}, 5);  // floating joints within
  add({.joints = 4, .branching = 0.2, .mix = {2, 0, 2, 1, 1, 1, 5}}, 5);
  add({.joints = 4, .branching = 0.3, .mix = {2, 0, 1, 1, 0, 0, 5}, .floating_base = true}, 3);
  return all;
}

constexpr std::array kCoriolisFunctions = {Function::coriolis_matrix, Function::kinetic_energy,
                                           Function::potential_energy};

using Digits = std::vector<Digits50>;

class Coriolis : public testing::TestWithParam<Seeded> {
 protected:
  Coriolis()
      : made_(random_mechanism(GetParam().seed, GetParam().options)),
        mechanism_(reduced_mechanism(made_.robot, made_.scene)),
        model_(model_from_robot<Digits50>(made_.robot, made_.scene)) {
    Rng rng(GetParam().seed + 7);
    q_ = random_position(rng, model_);
    qd_ = random_entries<Digits50>(rng, model_.nv, 4);
  }

  [[nodiscard]] Digits expected(Function function, const Vector50& q, const Vector50& qd) const {
    switch (function) {
      case Function::coriolis_matrix:
        return listed(ip::coriolis_matrix<Digits50>(model_, q, qd));
      case Function::kinetic_energy:
        return {ip::kinetic_energy<Digits50>(model_, q, qd)};
      default:
        return {ip::potential_energy<Digits50>(model_, q)};
    }
  }

  /// By the recursions as they stand, with the constants unrounded.
  [[nodiscard]] Digits recursion(Function function, const Digits& q, const Digits& qd) const {
    const auto tree = tree_of<Digits50>(mechanism_);
    const auto X = joint_transforms<Digits50>(tree, q);
    switch (function) {
      case Function::coriolis_matrix:
        return coriolis_matrix<Digits50>(tree, X, qd).values();
      case Function::kinetic_energy:
        return {kinetic_energy<Digits50>(tree, X, qd)};
      case Function::mass_matrix:
        return mass_matrix(tree, X).values();
      default:
        return {potential_energy(tree, X)};
    }
  }
  [[nodiscard]] Matrix50 matrix(const Digits& entries) const {
    return Eigen::Map<const Matrix50>(entries.data(), model_.nv, model_.nv);
  }

  RandomMechanism made_;
  Mechanism mechanism_;
  Model50 model_;
  Vector50 q_, qd_;
};

INSTANTIATE_TEST_SUITE_P(Robots, Coriolis, testing::ValuesIn(coriolis_robots()));

// Only a formula can be wrong.
TEST_P(Coriolis, RecursionsAgreeInFiftyDigits) {
  for (const Function function : kCoriolisFunctions) {
    const Results<Digits50> results{recursion(function, listed(q_), listed(qd_))};
    EXPECT_LT(relative_error(results, Results<Digits50>{expected(function, q_, qd_)}, 1), 1e-40)
        << function_name(function);
  }
}

TEST_P(Coriolis, RecursionLeavesASkewMatrix) {
  const Matrix50 C = matrix(recursion(Function::coriolis_matrix, listed(q_), listed(qd_)));
  const Matrix50 rate = derivative([&](const Digits50& t) {
    return matrix(recursion(Function::mass_matrix, listed(moved(model_, q_, qd_, t)), {}));
  });
  EXPECT_LT(relative_error(Matrix50(C + C.transpose()), rate), kDifference);
  const Vector50 b =
      ip::nonlinear_effects<Digits50>(model_, q_, qd_) - ip::gravity<Digits50>(model_, q_);
  EXPECT_LT(relative_error(Vector50(C * qd_), b), kAlgebra);
}

// With limbs in lanes and without.
TEST_P(Coriolis, TracedFunctionsAgreeWithTheInterpreter) {
  const auto q = rounded_to<double>(listed(q_));
  const auto qd = rounded_to<double>(listed(qd_));
  const auto as_vector = [](const std::vector<double>& entries) {
    Vector50 x(static_cast<Eigen::Index>(entries.size()));
    for (std::size_t i = 0; i < entries.size(); ++i) x(static_cast<Eigen::Index>(i)) = entries[i];
    return x;
  };
  Mechanism with_limbs = mechanism_;
  with_limbs.limbs = find_limbs(with_limbs, 8);
  for (const Mechanism* mechanism : {&mechanism_, &with_limbs}) {
    for (const Function function : kCoriolisFunctions) {
      const Results<Digits50> exact{expected(function, as_vector(q), as_vector(qd))};
      for (const Program& program : trace_function(*mechanism, function, 4)) {
        std::vector<std::vector<double>> arguments{q};
        if (program.arguments.size() > 1) arguments.push_back(qd);
        // Some roundings a link.
        EXPECT_LT(relative_error(evaluate<double>(program, arguments), exact, 1), 1e-13)
            << program.name;
      }
    }
  }
}

}  // namespace
}  // namespace treeline::tests
