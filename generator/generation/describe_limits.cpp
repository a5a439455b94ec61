#include "generation/describe_limits.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "description/active_rows.hpp"
#include "generation/describe_scene.hpp"
#include "program/evaluate.hpp"
#include "recursion/methods/ordinary_states.hpp"
#include "recursion/methods/passive_joints.hpp"

namespace treeline {
namespace {

/// How much more a level of priority weighs than the next: squares of accelerations times this.
constexpr double kPriorityWeight = 100;

/// A row of J that is this small beside others depends on them, or moves nothing.
constexpr double kDependentRow = 1e-9;

using Row = LimitFacts::Row;

/// Places of a constraint's rows among its own held rows; -1 for those that are not held.
std::array<int, 6> places_of(const ScenePoint& held) {
  std::array<int, 6> places{};
  int next = 0;
  for (std::size_t row = 0; row < 6; ++row) places[row] = held.rows[row] ? next++ : -1;
  return places;
}

/// Rows of one constraint's cone. Each is scaled to a force: a slack of 1 N widens all alike.
class ConeRows {
 public:
  ConeRows(const ScenePoint& held, const SceneCone& cone, int first)
      : places_(places_of(held)), cone_(cone), first_(first) {}

  [[nodiscard]] std::vector<Row> rows() {
    add({{2, -1.0}}, -cone_.least_force);
    const double inner = cone_.friction * std::cos(std::numbers::pi / cone_.sides);
    for (int side = 0; side < cone_.sides; ++side) {
      const double angle = 2 * std::numbers::pi * side / cone_.sides;
      add({{0, exact(std::cos(angle))}, {1, exact(std::sin(angle))}, {2, -inner}}, 0);
    }
    for (const double sign : {1.0, -1.0}) {
      if (cone_.half_extents) {
        add({{3, sign / (*cone_.half_extents)[1]}, {2, -1.0}}, 0);
        add({{4, sign / (*cone_.half_extents)[0]}, {2, -1.0}}, 0);
      }
      if (cone_.torsional) add({{5, sign / *cone_.torsional}, {2, -1.0}}, 0);
    }
    return rows_;
  }

 private:
  struct Part {
    std::size_t row;
    double coefficient;
  };

  /// Cosines and sines of quarter turns without their rounding error.
  static double exact(double x) { return std::abs(x) < 1e-15 ? 0 : x; }

  void add(std::initializer_list<Part> parts, double bound) {
    Row row{first_, std::vector<double>(6, 0.0), bound};
    for (const Part& part : parts) {
      row.coefficients[static_cast<std::size_t>(places_[part.row])] = part.coefficient;
    }
    while (row.coefficients.back() == 0) row.coefficients.pop_back();
    rows_.push_back(std::move(row));
  }

  std::array<int, 6> places_;
  const SceneCone& cone_;
  int first_;
  std::vector<Row> rows_;
};

std::string note_of(const SceneCone& cone) {
  std::string note = fmt::format("{}: friction {} by a pyramid of {} sides within the cone",
                                 cone.constraint, cone.friction, cone.sides);
  if (cone.torsional) note += fmt::format(", torsional friction {} m", *cone.torsional);
  if (cone.half_extents) {
    note += fmt::format(", centre of pressure within +-{} m along x, +-{} m along y",
                        (*cone.half_extents)[0], (*cone.half_extents)[1]);
  }
  return note + fmt::format(", normal force at least {} N", cone.least_force);
}

/// Constraints that can have cones, each with the place of its first held row.
template <class Visit>
void for_each_held(const Scene& scene, const Visit& visit) {
  int first = 0;
  const auto pass = [&](const ScenePoint& held) {
    visit(held, first);
    first += static_cast<int>(std::count(held.rows.begin(), held.rows.end(), true));
  };
  for (const ScenePoint& held : scene.constraints) pass(held);
  for (const SceneLoop& loop : scene.loops) pass(loop.first);
}

void add_cones(const Scene& scene, LimitFacts& facts) {
  for_each_held(scene, [&](const ScenePoint& held, int first) {
    for (const SceneCone& cone : scene.cones) {
      if (cone.constraint != held.name) continue;
      for (Row& row : ConeRows(held, cone, first).rows()) facts.cones.push_back(std::move(row));
      facts.notes.push_back(note_of(cone));
    }
  });
}

void add_force_weights(const Scene& scene, LimitFacts& facts) {
  const auto add = [&facts](const ScenePoint& point) {
    for (std::size_t row = 0; row < 6; ++row) {
      if (point.rows[row]) facts.force_weights.push_back(row < 3 ? 1 : kForceLever);
    }
  };
  for (const ScenePoint& held : scene.constraints) add(held);
  for (const SceneLoop& loop : scene.loops) add(loop.second);
  facts.force_weights.insert(facts.force_weights.end(), scene.couplings.size(), 1.0);
}

void add_task_weights(const Scene& scene, LimitFacts& facts) {
  int last = 1;
  for (const ScenePoint& point : scene.operational_points) last = std::max(last, point.priority);
  for (const ScenePoint& point : scene.operational_points) {
    const auto rows = std::count(point.rows.begin(), point.rows.end(), true);
    facts.task_weights.insert(facts.task_weights.end(), static_cast<std::size_t>(rows),
                              std::pow(kPriorityWeight, last - point.priority));
  }
}

/// Which share each held row and each row of the task has, where some come and go.
void add_shares(const Scene& scene, LimitFacts& facts) {
  if (scene.inputs.active.empty() && scene.inputs.active_tasks.empty()) return;
  facts.held_shares.assign(facts.force_weights.size(), -1);
  const ActiveRows active = find_active_rows(scene);
  for (std::size_t k = 0; k < active.size(); ++k) {
    for (const std::size_t row : active[k]) facts.held_shares[row] = static_cast<int>(k);
  }
  const auto& tasks = scene.inputs.active_tasks;
  for (const ScenePoint& point : scene.operational_points) {
    const auto named = std::find(tasks.begin(), tasks.end(), point.name);
    const auto rows = std::count(point.rows.begin(), point.rows.end(), true);
    facts.task_shares.insert(facts.task_shares.end(), static_cast<std::size_t>(rows),
                             named == tasks.end() ? -1 : static_cast<int>(named - tasks.begin()));
  }
}

/// Values of an argument of constraint_jacobian at coordinates q.
std::vector<double> value_of(const Argument& argument, const std::vector<double>& q) {
  std::vector<double> values = q;
  for (double& value : values) {
    if (argument.name == symbol_of(Quantity::sin_q)) value = std::sin(value);
    if (argument.name == symbol_of(Quantity::cos_q)) value = std::cos(value);
  }
  return values;
}

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// J of the held rows in ordinary states; none where nothing is held.
std::vector<Rows> held_jacobians(const Mechanism& mechanism,
                                 const std::vector<GeneratedFunction>& functions) {
  std::vector<Rows> jacobians;
  const auto found = std::find_if(
      functions.begin(), functions.end(),
      [](const GeneratedFunction& each) { return each.function == Function::constraint_jacobian; });
  if (found == functions.end()) return jacobians;
  const Argument& J = found->program.results.front().argument;
  for (int state = 0; state < kOrdinaryStates; ++state) {
    std::vector<std::vector<double>> arguments;
    for (const Argument& argument : found->program.arguments) {
      arguments.push_back(value_of(argument, ordinary_state(mechanism, state)));
    }
    const std::vector<double> values = evaluate<double>(found->program, arguments).front();
    jacobians.emplace_back(Rows::Map(values.data(), J.rows, J.cols));
  }
  return jacobians;
}

int held_rank(const std::vector<Rows>& jacobians) {
  Eigen::Index rank = 0;
  for (const Rows& J : jacobians) {
    Eigen::ColPivHouseholderQR<Rows> factors(J);
    factors.setThreshold(kDependentRow);
    rank = std::max(rank, factors.rank());
  }
  return static_cast<int>(rank);
}

}  // namespace

LimitFacts describe_limits(const Robot& robot, const Scene& scene, const Mechanism& mechanism,
                           const std::vector<GeneratedFunction>& functions) {
  LimitFacts facts;
  facts.passive = mechanism.passive;
  for (const auto& row : describe_scene(robot, scene, mechanism).velocity_rows) {
    const auto limit = scene.torque_limits.find(row.joint);
    facts.torque.push_back(limit == scene.torque_limits.end()
                               ? std::numeric_limits<double>::infinity()
                               : limit->second);
  }
  add_force_weights(scene, facts);
  add_cones(scene, facts);
  add_task_weights(scene, facts);
  add_shares(scene, facts);
  const int held = static_cast<int>(facts.force_weights.size());
  facts.freedoms = mechanism.nv() - static_cast<int>(facts.passive.size()) + held -
                   held_rank(held_jacobians(mechanism, functions));
  return facts;
}

void check_held_rows(const Scene& scene, const Mechanism& mechanism,
                     const std::vector<GeneratedFunction>& functions, Diagnostics& diagnostics) {
  if (!scene.has_limits()) return;
  const std::vector<Rows> jacobians = held_jacobians(mechanism, functions);
  if (!scene.inputs.active.empty() && held_rank(jacobians) < mechanism.held_rows()) {
    diagnostics.add({Severity::error, scene.file, 0, "inputs.active",
                     "rows of constraints depend on each other, so that forces within limits would "
                     "step when the last of them is held whole",
                     "Leave out rows that others hold, or remove active or the limits."});
  }
  for_each_held(scene, [&](const ScenePoint& held, int first) {
    const bool limited =
        std::any_of(scene.cones.begin(), scene.cones.end(),
                    [&](const SceneCone& cone) { return cone.constraint == held.name; });
    const Eigen::Index normal = first + places_of(held)[2];
    const auto moves = [&](const Rows& J) {
      return J.row(normal).cwiseAbs().maxCoeff() > kDependentRow * J.cwiseAbs().maxCoeff();
    };
    if (!limited || std::any_of(jacobians.begin(), jacobians.end(), moves)) return;
    diagnostics.add({Severity::error, scene.file, 0, fmt::format("constraints[{}]", held.name),
                     "no joint moves it along its normal, so that nothing tells the force of which "
                     "friction is a share",
                     "Let the robot lift there, as by `base: floating`, or remove friction."});
  });
}

}  // namespace treeline
