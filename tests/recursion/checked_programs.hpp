#pragma once

#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "mechanism/build_mechanism.hpp"
#include "mechanism/find_limbs.hpp"
#include "program/evaluate.hpp"
#include "recursion/function_results.hpp"
#include "recursion/routes/trace_function.hpp"

namespace treeline::tests {

/// Permitted rounding error in units of 2^-52 of the result's scale, times the condition numbers of
/// the solves. Every constant and every operation is rounded once. Along a chain of n links these
/// errors add up to some n units, with factors for products; n is at most ten in most robots drawn
/// here. Observed: 9 without a solve, 28 with one.
inline constexpr double kUlpBound = 64;

/// Lanes for which programs are traced beside those without: some routes are for lanes alone.
inline constexpr int kLanes = 8;

/// Largest error of each function, in ulp of the result's scale times the condition number.
class ErrorTable {
 public:
  void note(Function function, const std::string& route, double ulp, double growth) {
    Entry& entry = entries_[function];
    ++entry.compared;
    entry.worst_plain = std::max(entry.worst_plain, ulp);
    if (!(ulp / growth <= entry.worst)) {
      entry.worst = ulp / growth;
      entry.route = route;
    }
  }

  void expect_below(double bound) const {
    EXPECT_FALSE(entries_.empty());
    for (const auto& [function, entry] : entries_) {
      EXPECT_LE(entry.worst, bound) << function_name(function) << " by " << entry.route;
    }
  }

  void print() const {
    for (const auto& [function, entry] : entries_) {
      std::cout << "  " << function_name(function) << ": " << entry.compared
                << " results, worst error " << entry.worst_plain << " ulp, over the condition "
                << entry.worst << " (" << entry.route << ")\n";
    }
  }

 private:
  struct Entry {
    int compared = 0;
    double worst = 0, worst_plain = 0;
    std::string route;
  };
  std::map<Function, Entry> entries_;
};

/// All routes of all functions of a scene, traced once, with their oracle. Tasks are solved as they
/// are: what yields near singularities is compared in tests/check/singular_tasks_test.cpp.
class CheckedPrograms {
 public:
  CheckedPrograms(const Robot& robot, Scene scene) : oracle_(robot, scene) {
    scene.singular = SingularTasks::exact;
    Mechanism mechanism = reduced_mechanism(robot, scene);
    append(mechanism, 1);
    mechanism.limbs = find_limbs(mechanism, kLanes);
    append(mechanism, kLanes);
  }

  [[nodiscard]] const Oracle<Digits50>& oracle() const { return oracle_; }
  [[nodiscard]] const std::vector<std::pair<Function, std::vector<Program>>>& programs() const {
    return programs_;
  }

  /// Evaluates in `Scalar` with the inputs rounded to doubles. The reference uses the same doubles.
  template <class Scalar>
  void compare(const Inputs<Digits50>& drawn, ErrorTable& table) const {
    const Inputs<double> in = rounded_to<double>(drawn);
    const Inputs<Digits50> exact = rounded_to<Digits50>(in);
    const Yardstick size = yardstick(oracle_, exact);
    for (const auto& [function, routes] : programs_) {
      if (!permits(function, oracle_.has_points(), size)) continue;
      const Results<Digits50> expected = oracle_.results(function, exact);
      for (const Program& program : routes) {
        const auto results = evaluate<Scalar>(program, arguments(program, rounded_to<Scalar>(in)));
        const double error = relative_error(results, expected, size.least_scale(function));
        table.note(function, describe(program.route), error * 0x1p52, size.growth(function));
      }
    }
  }

  /// The inputs in the order of the program's arguments.
  template <class Scalar>
  static std::vector<std::vector<Scalar>> arguments(const Program& program,
                                                    const Inputs<Scalar>& in) {
    std::vector<std::vector<Scalar>> values;
    for (const Argument& argument : program.arguments) {
      const std::string& name = argument.name;
      values.push_back(name == "q"                        ? in.q
                       : name == "qd"                     ? in.qd
                       : name == "qdd" || name == "qdd_0" ? in.qdd
                       : name == "tau"                    ? in.tau
                       : name == "xdd_cmd"                ? in.xdd_cmd
                                                          : in.f_ext);
      EXPECT_EQ(static_cast<int>(values.back().size()), argument.rows) << name;
    }
    return values;
  }

 private:
  void append(const Mechanism& mechanism, int lanes) {
    for (const Function function : kDefaultFunctions) {
      if (!needs_points(function) || oracle_.has_points()) {
        programs_.emplace_back(function, trace_function(mechanism, function, lanes));
      }
    }
  }

  Oracle<Digits50> oracle_;
  std::vector<std::pair<Function, std::vector<Program>>> programs_;
};

}  // namespace treeline::tests
