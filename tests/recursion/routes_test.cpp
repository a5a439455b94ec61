#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "program/evaluate.hpp"
#include "recursion/checked_programs.hpp"
#include "recursion/template_results.hpp"

// Every route of every function for random robots, compared with the interpreter in 50 digits for
// the robot as written in the files. Would catch: a wrong formula in any recursion, a
// simplification of the graph that is not an identity, a route that is used where it does not
// apply, and loss of digits.

namespace treeline::tests {
namespace {

struct Sweep {
  RandomOptions options;
  std::uint64_t first_seed = 1;
  int count = 1;
};

template <class Check>
void for_each_robot(const Sweep& sweep, Check check) {
  for (int k = 0; k < sweep.count; ++k) {
    const std::uint64_t seed = sweep.first_seed + static_cast<std::uint64_t>(k);
    SCOPED_TRACE(described(seed, sweep.options));
    const RandomMechanism made = random_mechanism(seed, sweep.options);
    if (model_from_robot<double>(made.robot, made.scene).nv > 0) check(made, seed);
  }
}

RandomOptions options_of(int joints, double branching, int points, int forces) {
  RandomOptions options;
  options.joints = joints;
  options.branching = branching;
  options.operational_points = points;
  options.external_forces = forces;
  return options;
}

/// Chains and trees, all rows and some, points that share links or lie on each other's ancestors.
std::vector<Sweep> sweeps() {
  std::vector<Sweep> all{{options_of(1, 0, 1, 1), 1, 8},    {options_of(7, 0, 1, 0), 10, 6},
                         {options_of(9, 0.5, 3, 2), 20, 6}, {options_of(8, 0.4, 2, 1), 30, 6},
                         {options_of(8, 0.4, 2, 1), 40, 6}, {options_of(6, 0.2, 2, 1), 50, 5},
                         {options_of(5, 0.3, 2, 1), 60, 6}, {options_of(5, 0.3, 2, 1), 70, 6},
                         {options_of(5, 0, 1, 1), 80, 4},   {options_of(6, 0.3, 2, 1), 90, 6},
                         {options_of(5, 0.3, 2, 1), 100, 4}};
  all[2].options.all_rows = false;
  all[3].options.floating_base = true;
  all[4].options.mimic = 0.4;
  all[4].options.locked = 0.1;
  all[4].options.all_rows = false;
  all[5].options.mix.floating = 2;
  all[5].options.mix.planar = 2;
  all[6].options.mix.ball = 8;
  all[7].options.mix.ball = 5;
  all[7].options.floating_base = true;
  all[8].options.mix = {2, 1, 1, 0, 0, 1, 5};
  all[8].options.mimic = 0.4;
  all[9].options.rotors = 0.7;
  all[9].options.drives = 0.5;
  all[9].options.mimic = 0.3;
  all[10].options.rotors = 0.7;
  all[10].options.drives = 0.5;
  all[10].options.floating_base = true;
  return all;
}

// In 50 digits with unrounded constants only the formulas can differ.
TEST(Routes, OfTheTemplatesAgreeInFiftyDigits) {
  std::map<std::string, double> worst;
  std::map<std::string, int> compared;
  for (const Sweep& sweep : sweeps()) {
    for_each_robot(sweep, [&](const RandomMechanism& made, std::uint64_t seed) {
      Rng rng(seed);
      const Oracle<Digits50> oracle(made.robot, made.scene);
      const Inputs<Digits50> in = oracle.random_inputs(rng, 5);
      const Yardstick size = yardstick(oracle, in);
      const TemplateRun<Digits50> run(reduced_mechanism(made.robot, made.scene), in);
      for (const Function function : kDefaultFunctions) {
        if (!permits(function, oracle.has_points(), size)) continue;
        const auto expected = oracle.results(function, in);
        for (const auto& [route, results] : run.results(function)) {
          const double error =
              relative_error(results, expected, size.least_scale(function)) / size.growth(function);
          EXPECT_LE(error, 1e-41) << function_name(function) << " " << route;
          worst[function_name(function)] = std::max(worst[function_name(function)], error);
          ++compared[function_name(function)];
        }
      }
    });
  }
  for (const auto& [name, error] : worst) {
    EXPECT_GE(compared[name], 10) << name;
    std::cout << name << ": " << compared[name] << " compared, worst " << error << '\n';
  }
}

// In 50 digits the graph differs only by its constants, each of which is rounded once to double.
TEST(Routes, OfTheProgramsAgreeInFiftyDigitsUpToTheirConstants) {
  ErrorTable table;
  for (const Sweep& sweep : sweeps()) {
    for_each_robot(sweep, [&](const RandomMechanism& made, std::uint64_t seed) {
      Rng rng(seed + 100);
      const CheckedPrograms programs(made.robot, made.scene);
      programs.compare<Digits50>(programs.oracle().random_inputs(rng), table);
    });
  }
  table.expect_below(kUlpBound);
}

TEST(Routes, OfTheProgramsAgreeInDouble) {
  ErrorTable table;
  for (const Sweep& sweep : sweeps()) {
    for_each_robot(sweep, [&](const RandomMechanism& made, std::uint64_t seed) {
      Rng rng(seed + 200);
      const CheckedPrograms programs(made.robot, made.scene);
      for (int state = 0; state < 3; ++state) {
        programs.compare<double>(programs.oracle().random_inputs(rng), table);
      }
    });
  }
  table.expect_below(kUlpBound);
  table.print();
}

// The place of a robot does not affect its motion: far from the world's origin no digits may be
// lost, except in positions.
TEST(Routes, OfTheProgramsAgreeFarFromTheOrigin) {
  ErrorTable table;
  Sweep sweep{options_of(7, 0.4, 2, 1), 60, 5};
  sweep.options.floating_base = true;
  for_each_robot(sweep, [&](const RandomMechanism& made, std::uint64_t seed) {
    Rng rng(seed);
    const CheckedPrograms programs(made.robot, made.scene);
    Inputs<Digits50> in = programs.oracle().random_inputs(rng);
    for (std::size_t i = 0; i < 3; ++i) in.q[i] *= 1e6;
    programs.compare<double>(in, table);
  });
  table.expect_below(kUlpBound);
}

// Long chains and wide trees: errors that grow with the number of links.
TEST(Routes, OfLargeRobotsAgreeInDouble) {
  ErrorTable table;
  for (const Sweep& sweep :
       {Sweep{options_of(40, 0, 1, 0), 1, 1}, Sweep{options_of(40, 0.3, 2, 1), 2, 1},
        Sweep{options_of(24, 0.8, 4, 0), 3, 2}}) {
    for_each_robot(sweep, [&](const RandomMechanism& made, std::uint64_t seed) {
      Rng rng(seed + 300);
      const CheckedPrograms programs(made.robot, made.scene);
      programs.compare<double>(programs.oracle().random_inputs(rng), table);
    });
  }
  table.expect_below(4 * kUlpBound);
  table.print();
}

}  // namespace
}  // namespace treeline::tests
