#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "interpreter/supported_cases.hpp"
#include "mechanism/build_mechanism.hpp"
#include "program/evaluate.hpp"
#include "recursion/methods/task_law.hpp"
#include "recursion/routes/trace_function.hpp"

// Constraints and tasks that come and go by the arguments `active` and `active_tasks`, every route,
// as traced. Would catch: a row that is gone and still acts, a row that is whole and is not the row
// of a scene without the argument, rows of another constraint or task that yield, and a step in a
// result while a share rises.

namespace treeline::tests {
namespace {

constexpr std::array kFunctions{Function::constrained_forward_dynamics,
                                Function::supported_control_torque};

/// The constraints of a scene, to the world first.
std::size_t count_constraints(const Scene& scene) {
  return scene.constraints.size() + scene.loops.size();
}

/// The robot with all constraints and tasks named under `active`.
RandomMechanism with_activity(RandomMechanism made) {
  for (const ScenePoint& held : made.scene.constraints) {
    made.scene.inputs.active.push_back(held.name);
  }
  for (const SceneLoop& loop : made.scene.loops) {
    made.scene.inputs.active.push_back(loop.first.name);
  }
  for (const ScenePoint& point : made.scene.operational_points) {
    made.scene.inputs.active_tasks.push_back(point.name);
  }
  return made;
}

/// Which constraints are held, then which tasks are done, a bit each.
using Mode = unsigned;

bool is_held(Mode mode, std::size_t part) {
  return (mode >> part & 1U) != 0;
}

template <class Part>
void keep_held(Mode mode, std::size_t first, std::vector<Part>& parts) {
  std::vector<Part> kept;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (is_held(mode, first + i)) kept.push_back(parts[i]);
  }
  parts = std::move(kept);
}

/// The mechanism with the constraints and tasks of a mode alone, all the time.
Mechanism in_mode(Mechanism mechanism, Mode mode) {
  mechanism.inputs.active.clear();
  mechanism.inputs.active_tasks.clear();
  keep_held(mode, mechanism.constraints.size() + mechanism.loops.size(),
            mechanism.operational_points);
  keep_held(mode, mechanism.constraints.size(), mechanism.loops);
  keep_held(mode, 0, mechanism.constraints);
  return mechanism;
}

/// By row that is held to the world, or of all that are held, whether its constraint is of a mode.
std::vector<bool> rows_of(const Scene& scene, Mode mode, bool with_loops) {
  std::vector<bool> held;
  std::size_t constraint = 0;
  const auto add = [&](const ScenePoint& point) {
    const auto rows = std::count(point.rows.begin(), point.rows.end(), true);
    held.insert(held.end(), static_cast<std::size_t>(rows), is_held(mode, constraint++));
  };
  for (const ScenePoint& point : scene.constraints) add(point);
  for (const SceneLoop& loop : scene.loops) {
    if (with_loops) add(loop.second);
  }
  if (with_loops) held.insert(held.end(), scene.couplings.size(), true);
  return held;
}

/// By row of the tasks, whether its task is of a mode.
std::vector<bool> task_rows_of(const Scene& scene, Mode mode) {
  std::vector<bool> done;
  std::size_t part = count_constraints(scene);
  for (const ScenePoint& point : scene.operational_points) {
    const auto rows = std::count(point.rows.begin(), point.rows.end(), true);
    done.insert(done.end(), static_cast<std::size_t>(rows), is_held(mode, part++));
  }
  return done;
}

std::vector<double> entries_where(const std::vector<bool>& chosen, const std::vector<double>& all) {
  std::vector<double> entries;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (chosen[i]) entries.push_back(all[i]);
  }
  return entries;
}

std::vector<double> in_double(const Vector50& x) {
  return rounded_to<double>(listed(x));
}

/// Arguments of a program for the constraints and tasks of a mode, with their shares.
std::vector<std::vector<double>> arguments(const Program& program, const StandingCase& c, Mode mode,
                                           const std::vector<double>& shares) {
  const Scene& scene = c.made.scene;
  const auto first_task =
      shares.begin() + (shares.empty() ? 0 : static_cast<std::ptrdiff_t>(count_constraints(scene)));
  const std::map<std::string, std::vector<double>> values{
      {"q", in_double(c.q)},
      {"qd", in_double(c.qd)},
      {"tau", in_double(c.tau)},
      {"qdd_0", in_double(c.task.qdd_0)},
      {"xdd_cmd", entries_where(task_rows_of(scene, mode), in_double(c.task.xdd_cmd))},
      {"f_ext", in_double(c.task.f_ext)},
      {"stabilisation", {20, 100}},
      {"drift", entries_where(rows_of(scene, mode, false), in_double(c.drift))},
      {"f_wanted", entries_where(rows_of(scene, mode, true), in_double(c.task.f_wanted))},
      {"active", {shares.begin(), first_task}},
      {"active_tasks", {first_task, shares.end()}}};
  std::vector<std::vector<double>> chosen;
  for (const Argument& argument : program.arguments) {
    chosen.push_back(values.at(argument.name));
    EXPECT_EQ(static_cast<int>(chosen.back().size()), argument.rows) << argument.name;
  }
  return chosen;
}

Results<double> results_at(const Program& program, const StandingCase& c, Mode mode,
                           const std::vector<double>& shares = {}) {
  return evaluate<double>(program, arguments(program, c, mode, shares));
}

/// The program by the same route; null where there is none.
const Program* find_route(const std::vector<Program>& programs, const Program& like) {
  const auto found = std::find_if(programs.begin(), programs.end(), [&](const Program& program) {
    return key_of(program.route) == key_of(like.route);
  });
  return found == programs.end() ? nullptr : &*found;
}

/// Whether the function of this set is there.
bool permits(Function function, const Mechanism& mechanism) {
  return mechanism.held_rows() > 0 ||
         (function == Function::supported_control_torque && !mechanism.operational_points.empty());
}

/// Whether a program lets passive joints move, as those do whose constraints come and go.
bool moves_passive(const Program& program) {
  return program.law->kind != TaskLaw::Kind::supported || program.law->mechanism->passive.empty() ||
         split_rules(*program.law).passive_moves;
}

class Activity : public testing::TestWithParam<const char*> {
 protected:
  Activity() {
    for (const Standing& standing : standings_and_loops()) {
      if (std::string(standing.name) == GetParam()) c_ = draw_standing_regular(7, standing);
    }
    mechanism_ = reduced_mechanism(c_.made.robot, with_activity(c_.made).scene);
    for (const Function function : kFunctions) {
      programs_.push_back(trace_function(mechanism_, function));
    }
  }
  [[nodiscard]] std::size_t constraints() const { return count_constraints(c_.made.scene); }
  /// Constraints and tasks.
  [[nodiscard]] std::size_t parts() const {
    return constraints() + c_.made.scene.operational_points.size();
  }
  /// Cases have points of which no row is left.
  [[nodiscard]] bool has_rows(std::size_t part) const {
    if (part < constraints()) return true;
    const auto& on = c_.made.scene.operational_points[part - constraints()].rows;
    return std::count(on.begin(), on.end(), true) > 0;
  }
  [[nodiscard]] Mode whole() const { return (1U << parts()) - 1; }

  /// Results of a program with all constraints and tasks while it holds those of a mode. The forces
  /// of others, which must be 0, are left out.
  [[nodiscard]] Results<double> results_in(Mode mode, const Program& program) const {
    std::vector<double> shares;
    for (std::size_t i = 0; i < parts(); ++i) shares.push_back(is_held(mode, i) ? 1 : 0);
    Results<double> results = results_at(program, c_, whole(), shares);
    const auto held = rows_of(c_.made.scene, mode, true);
    for (std::size_t i = 0; i < held.size(); ++i) {
      if (!held[i]) EXPECT_EQ(results[1][i], 0) << "row " << i;
    }
    results[1] = entries_where(held, results[1]);
    if (results[1].empty()) results.pop_back();
    return results;
  }

  StandingCase c_;
  Mechanism mechanism_;
  std::vector<std::vector<Program>> programs_;  ///< by function
};

INSTANTIATE_TEST_SUITE_P(Standing, Activity,
                         testing::Values("two_feet", "three_points", "foot_and_edge", "two_points",
                                         "passive_joints_at_a_wall", "hand_at_a_wall", "pushed",
                                         "drives", "two_loops", "loop_on_a_foot", "coupled_loop",
                                         "two_wheels"));

// Each set of constraints by the one function, against the function of this set by the same route.
// The whole set takes the same operations, but where no passive joint can move with it alone.
TEST_P(Activity, EverySetHasTheValuesOfItsOwnFunction) {
  for (Mode mode = 0; mode <= whole(); ++mode) {
    const Mechanism mechanism = in_mode(mechanism_, mode);
    for (std::size_t k = 0; k < kFunctions.size(); ++k) {
      if (!permits(kFunctions[k], mechanism)) continue;
      const auto of_set = trace_function(mechanism, kFunctions[k]);
      for (const Program& program : programs_[k]) {
        const Program* const own = find_route(of_set, program);
        if (own == nullptr) continue;
        SCOPED_TRACE(program.name + " by " + describe(program.route) + ", set " +
                     std::to_string(mode));
        const auto actual = results_in(mode, program);
        const auto expected = results_at(*own, c_, mode);
        if (mode == whole() && moves_passive(*own)) EXPECT_EQ(actual, expected);
        // A quarter of an ulp of the result's scale, times the condition number of the solves: sums
        // have zeros more, and their terms in another order.
        EXPECT_LE(relative_error(actual, expected, 1) * 0x1p52 / c_.growth, 0.25);
      }
    }
  }
}

/// All results in one list.
std::vector<double> all_of(const Results<double>& results) {
  std::vector<double> all;
  for (const auto& result : results) all.insert(all.end(), result.begin(), result.end());
  return all;
}

/// From zero, where nothing is said.
double largest_change(const std::vector<double>& from, const std::vector<double>& to) {
  double largest = 0;
  for (std::size_t i = 0; i < to.size(); ++i) {
    largest = std::max(largest, std::fabs(to[i] - (from.empty() ? 0 : from[i])));
  }
  return largest;
}

// Next to 0 and to 1, where a row comes and where it is whole: the nearer a share, sixteenfold, the
// less the results differ, at least eightfold but for rounding. Shares are nearer than any border,
// at which rows begin to yield.
TEST_P(Activity, NothingStepsWhileAShareRises) {
  for (std::size_t k = 0; k < kFunctions.size(); ++k) {
    const Program& program = programs_[k].front();
    const bool does_tasks = kFunctions[k] == Function::supported_control_torque;
    for (std::size_t i = 0; i < (does_tasks ? parts() : constraints()); ++i) {
      if (!has_rows(i)) continue;
      SCOPED_TRACE(program.name + ", constraint or task " + std::to_string(i));
      std::vector<double> shares(parts(), 1);
      const auto at = [&](double share) {
        shares[i] = share;
        return all_of(results_at(program, c_, whole(), shares));
      };
      for (const double end : {0.0, 1.0}) {
        const auto from = at(end);
        const auto change = [&](double h) { return largest_change(from, at(std::fabs(end - h))); };
        const double rounding = 0x1p-52 * c_.growth * largest_change({}, from);
        EXPECT_LE(change(0x1p-32), change(0x1p-28) / 8 + rounding) << "at " << end;
        EXPECT_GT(change(0x1p-3), 0x1p10 * rounding) << "at " << end;
      }
    }
  }
}

}  // namespace
}  // namespace treeline::tests
