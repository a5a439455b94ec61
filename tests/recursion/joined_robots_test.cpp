#include <gtest/gtest.h>

#include <iostream>
#include <numeric>

#include "description/rotation.hpp"
#include "interpreter/object_forward_dynamics.hpp"
#include "joined_mechanisms.hpp"
#include "oracle/model_from_robot.hpp"
#include "passes/count_operations.hpp"
#include "recursion/checked_programs.hpp"

// Robots joined in one scene, compared with each of them alone: random pairs and triples, fixed and
// floating bases, turned bases. Would catch: a base at another place than its pose, coordinates or
// rows in another order, a mimic, lock, rotor or spring that belongs to another robot's joint, and
// operations for what is zero between robots.

namespace treeline::tests {
namespace {

struct Together {
  const char* name;
  std::vector<bool> floats;  ///< for each robot, whether its base floats
};

std::ostream& operator<<(std::ostream& out, const Together& together) {
  return out << together.name;
}

std::vector<PlacedMechanism> draw_parts(std::uint64_t seed, const Together& together) {
  std::vector<PlacedMechanism> parts;
  for (const bool floats : together.floats) {
    RandomOptions options;
    options.joints = 5;
    options.mix = {5, 1, 2, 0.5, 0.2, 0.3, 0.3};
    options.mimic = options.locked = 0.15;
    options.rotors = options.drives = 0.3;
    options.external_forces = 1;
    options.floating_base = floats;
    PlacedMechanism part{random_mechanism(seed, options), {}};
    part.made.scene.gravity = {0, 0, -9.81};
    Rng rng(seed + 3);
    if (!floats) {
      part.pose.xyz = detail::random_vector(rng, 2);
      part.pose.rpy[2] = rng.rounded(-3, 3);
    }
    // Rows along the link's axes do not depend on how the base is turned.
    for (ScenePoint& point : part.made.scene.operational_points) point.axes = Axes::local;
    for (ScenePoint& point : part.made.scene.external_forces) point.axes = Axes::local;
    parts.push_back(std::move(part));
    seed += 101;
  }
  return parts;
}

Oracle<Digits50> oracle_of(const RandomMechanism& made) {
  return {made.robot, made.scene};
}

void append(const std::vector<Digits50>& values, std::vector<Digits50>& to) {
  to.insert(to.end(), values.begin(), values.end());
}

/// The inputs of all robots, one after another.
Inputs<Digits50> together(const std::vector<Inputs<Digits50>>& each) {
  Inputs<Digits50> all;
  for (const Inputs<Digits50>& one : each) {
    for (auto list :
         {&Inputs<Digits50>::q, &Inputs<Digits50>::qd, &Inputs<Digits50>::qdd,
          &Inputs<Digits50>::tau, &Inputs<Digits50>::xdd_cmd, &Inputs<Digits50>::f_ext}) {
      append(one.*list, all.*list);
    }
  }
  return all;
}

/// The result of all robots from that of each: blocks on the diagonal, lists one after another, or
/// a sum.
std::vector<Digits50> assembled(Function function, const std::vector<std::vector<Digits50>>& each,
                                const std::vector<int>& rows, const std::vector<int>& columns) {
  std::vector<Digits50> all;
  switch (function) {
    case Function::kinetic_energy:
    case Function::potential_energy:
      return {std::accumulate(
          each.begin(), each.end(), Digits50(0),
          [](const Digits50& sum, const auto& own) { return Digits50(sum + own.front()); })};
    case Function::jacobian:
    case Function::mass_matrix:
    case Function::coriolis_matrix:
    case Function::lambda_inverse:
      break;
    default:
      for (const auto& own : each) append(own, all);
      return all;
  }
  const int width = std::accumulate(columns.begin(), columns.end(), 0);
  int first = 0;
  for (std::size_t k = 0; k < each.size(); ++k) {
    for (int i = 0; i < rows[k]; ++i) {
      std::vector<Digits50> row(static_cast<std::size_t>(width), Digits50(0));
      for (int j = 0; j < columns[k]; ++j) {
        row[static_cast<std::size_t>(first + j)] =
            each[k][static_cast<std::size_t>(i * columns[k] + j)];
      }
      append(row, all);
    }
    first += columns[k];
  }
  return all;
}

class JoinedRobots : public testing::TestWithParam<std::tuple<Together, int>> {
 protected:
  JoinedRobots()
      : seed_(7 + 53 * static_cast<std::uint64_t>(std::get<1>(GetParam()))),
        parts_(draw_parts(seed_, std::get<0>(GetParam()))),
        joined_(joined(parts_)) {
    std::cout << "seed " << seed_ << '\n';
  }
  std::uint64_t seed_;
  std::vector<PlacedMechanism> parts_;
  RandomMechanism joined_;
};

const Together kTogether[] = {{"two_fixed", {false, false}},
                              {"two_floating", {true, true}},
                              {"fixed_and_floating", {false, true}},
                              {"three", {true, false, false}}};

INSTANTIATE_TEST_SUITE_P(Random, JoinedRobots,
                         testing::Combine(testing::ValuesIn(kTogether), testing::Range(0, 3)),
                         [](const auto& tested) {
                           return std::string(std::get<0>(tested.param).name) + "_" +
                                  std::to_string(std::get<1>(tested.param));
                         });

constexpr std::array kCompared = {Function::jacobian,          Function::bias_acceleration,
                                  Function::inverse_dynamics,  Function::gravity,
                                  Function::nonlinear_effects, Function::mass_matrix,
                                  Function::coriolis_matrix,   Function::kinetic_energy,
                                  Function::forward_dynamics,  Function::lambda_inverse};

// In 50 digits nothing but the structure can differ.
TEST_P(JoinedRobots, AreEachAloneInFiftyDigits) {
  const auto oracle = oracle_of(joined_);
  Rng rng(seed_);
  std::vector<Inputs<Digits50>> in;
  std::vector<Oracle<Digits50>> alone;
  std::vector<int> velocities, rows;
  for (const PlacedMechanism& part : parts_) {
    alone.push_back(oracle_of(part.made));
    in.push_back(alone.back().random_inputs(rng));
    velocities.push_back(alone.back().model().nv);
    rows.push_back(alone.back().task_rows());
  }
  const Inputs<Digits50> all = together(in);
  ASSERT_EQ(oracle.model().nv, std::accumulate(velocities.begin(), velocities.end(), 0));
  for (const Function function : kCompared) {
    std::vector<std::vector<Digits50>> each;
    for (std::size_t k = 0; k < alone.size(); ++k) {
      each.push_back(alone[k].results(function, in[k]).front());
    }
    const bool of_joints =
        function == Function::mass_matrix || function == Function::coriolis_matrix;
    const auto& columns = function == Function::lambda_inverse ? rows : velocities;
    const auto expected = assembled(function, each, of_joints ? velocities : rows, columns);
    const double error =
        relative_error<Digits50, Digits50>(oracle.results(function, all), {expected}, 1e-3);
    EXPECT_LE(error, 1e-40) << function_name(function);
  }
}

// The pose of a base: points are those of the robot alone, turned about z and shifted.
TEST_P(JoinedRobots, StandWhereTheScenePutsThem) {
  const auto oracle = oracle_of(joined_);
  Rng rng(seed_);
  std::vector<Inputs<Digits50>> in;
  Results<Digits50> expected(2);
  for (const PlacedMechanism& part : parts_) {
    const auto alone = oracle_of(part.made);
    in.push_back(alone.random_inputs(rng));
    const auto own = alone.results(Function::forward_kinematics, in.back());
    const auto R = rotation_from_rpy<Digits50>(part.pose.rpy);
    for (std::size_t first = 0; first < own[0].size(); first += 3) {
      for (int i = 0; i < 3; ++i) {
        Digits50 sum(part.pose.xyz[static_cast<std::size_t>(i)]);
        for (int j = 0; j < 3; ++j) sum += R(i, j) * own[0][first + static_cast<std::size_t>(j)];
        expected[0].push_back(sum);
      }
    }
    for (std::size_t first = 0; first < own[1].size(); first += 9) {
      const auto turn = interpreter::Matrix3<Digits50>::Map(own[1].data() + first).transpose();
      append(listed(interpreter::Matrix3<Digits50>(R * turn)), expected[1]);
    }
  }
  const auto actual = oracle.results(Function::forward_kinematics, together(in));
  EXPECT_LE(relative_error(actual, expected, 1), 1e-45);
}

// All routes, as they are emitted, with and without lanes for alike robots.
TEST_P(JoinedRobots, ProgramsAgreeInDouble) {
  const CheckedPrograms checked(joined_.robot, joined_.scene);
  ErrorTable table;
  Rng rng(seed_);
  for (int i = 0; i < 3; ++i) {
    checked.compare<double>(checked.oracle().random_inputs(rng), table);
  }
  table.print();
  table.expect_below(kUlpBound);
}

/// Operations of a function by route.
std::map<std::string, int> count_by_route(const RandomMechanism& made, Function function) {
  std::map<std::string, int> counts;
  for (const Program& program :
       trace_function(reduced_mechanism(made.robot, made.scene), function)) {
    counts[describe(program.route)] = count_operations(program).flops();
  }
  return counts;
}

constexpr std::array kCounted = {Function::forward_kinematics,
                                 Function::jacobian,
                                 Function::bias_acceleration,
                                 Function::inverse_dynamics,
                                 Function::gravity,
                                 Function::nonlinear_effects,
                                 Function::mass_matrix,
                                 Function::forward_dynamics,
                                 Function::lambda_inverse,
                                 Function::lambda,
                                 Function::control_torque};

// By any algorithm: one for all robots need not be the cheapest for each of them.
TEST_P(JoinedRobots, CostTheirSum) {
  for (const Function function : kCounted) {
    std::map<std::string, int> sums = count_by_route(joined({parts_[0]}), function);
    for (std::size_t k = 1; k < parts_.size(); ++k) {
      const auto own = count_by_route(joined({parts_[k]}), function);
      std::erase_if(sums, [&](const auto& entry) { return !own.contains(entry.first); });
      for (auto& [route, sum] : sums) sum += own.at(route);
    }
    const auto counts = count_by_route(joined_, function);
    for (const auto& [route, sum] : sums) {
      if (!counts.contains(route)) continue;
      EXPECT_LE(counts.at(route), sum) << function_name(function) << " by " << route;
    }
  }
}

TEST_P(JoinedRobots, AreZeroBetweenEachOther) {
  const Mechanism mechanism = reduced_mechanism(joined_.robot, joined_.scene);
  std::vector<int> owner;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Mechanism own = reduced_mechanism(parts_[k].made.robot, parts_[k].made.scene);
    owner.insert(owner.end(), static_cast<std::size_t>(own.nv()), static_cast<int>(k));
  }
  for (const Program& program : trace_function(mechanism, Function::mass_matrix)) {
    const auto& entries = program.results.front().values;
    ASSERT_EQ(entries.size(), owner.size() * owner.size());
    for (std::size_t i = 0; i < owner.size(); ++i) {
      for (std::size_t j = 0; j < owner.size(); ++j) {
        if (owner[i] == owner[j]) continue;
        EXPECT_TRUE(entries[i * owner.size() + j].is_zero()) << i << ", " << j;
      }
    }
  }
}

}  // namespace
}  // namespace treeline::tests
