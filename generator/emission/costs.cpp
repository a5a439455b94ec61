#include "emission/costs.hpp"

#include <algorithm>
#include <array>

#include "core/emitted_damped.hpp"
#include "core/emitted_limits.hpp"
#include "passes/count_operations.hpp"

namespace treeline {
namespace {

/// Adds so many times these operations.
void add(OperationCount& count, int times, int additions, int products, int quotients) {
  count.add += times * additions;
  count.mul += times * products;
  count.div += times * quotients;
}

/// `tl_diagonalise` of an n x n matrix in so many sweeps. Returns how many square roots that
/// takes.
int add_diagonalisation(OperationCount& count, int n, int sweeps) {
  add(count, 1, 0, n * (n + 1) / 2, 1);  // scaled to 1
  for (int m = n - 1; m >= 2; --m) {     // a reflection of m entries
    add(count, m, 1, 1, 0);              // their length
    add(count, 1, 2, 1, 1);              // v
    add(count, m * m, 1, 1, 0);          // A v
    add(count, m, 2, 3, 0);              // w
    add(count, 1, 0, 2, 0);
    add(count, m * (m + 1) / 2, 2, 2, 0);  // A
  }
  add(count, sweeps, 6, 4, 1);             // shift, and the ends
  add(count, sweeps * (n - 1), 7, 11, 1);  // rotations
  add(count, n, 0, 1, 0);                  // scaled back
  return (n > 2 ? n - 2 : 0) + sweeps * n;
}

/// `tl_turn`, or `tl_turn_back`.
void add_turn(OperationCount& count, int n, int sweeps) {
  for (int m = n - 1; m >= 2; --m) add(count, 1, 2 * m, 2 * m + 1, 0);
  add(count, sweeps * (n - 1), 2, 4, 0);
}

}  // namespace

bool is_called_by_damped(const std::string& function) {
  constexpr std::array kCalled = {"lambda_inverse", "jacobian", "bias_acceleration",
                                  "inverse_dynamics"};
  return std::find(kCalled.begin(), kCalled.end(), function) != kCalled.end();
}

DampedCost cost_of_damped_solve(int n, int velocities, bool single_precision) {
  const int sweeps = single_precision ? core::ql_sweeps<float>(n) : core::ql_sweeps<double>(n);
  const int pairs = n * (n - 1) / 2;
  DampedCost cost;
  OperationCount& count = cost.count;
  add(count, n, 1 + velocities, velocities, 0);  // F = xdd_cmd - bias - J qdd_0
  add(count, n, 0, 1, 0);                        // S b
  add(count, n + pairs, 0, 2, 0);                // S Lambda^-1 S
  cost.square_roots = n + add_diagonalisation(count, n, sweeps);
  add_turn(count, n, sweeps);
  add_turn(count, n, sweeps);
  add(count, 1, 0, 1, 0);                          // border
  add(count, n, 2, 3, 2);                          // delta of each eigenvalue, and the quotient
  add(count, n, 0, 1, 0);                          // S x
  add(count, pairs, 1, 2, 1);                      // pivots of L D L^T, and L
  add(count, n * (n - 1) * (n - 2) / 6, 1, 1, 0);  // what is below them
  add(count, pairs, 2, 2, 0);                      // both triangles
  add(count, n, 0, 0, 1);                          // and D
  add(count, n * velocities, 1, 1, 0);             // tau += J^T F
  // Of which 14 in a sweep.
  cost.values = 2 * n * n + n * velocities + 7 * n + 2 * sweeps * (n - 1) + 14;
  return cost;
}

DampedCost cost_of_damped(const EmissionContext& context, std::span<const Program> programs) {
  DampedCost cost =
      cost_of_damped_solve(context.task_rows, context.velocities, context.single_precision);
  int live = 0;
  for (const Program& program : programs) {
    if (!is_called_by_damped(program.name)) continue;
    const OperationCount own = count_operations(program);
    cost.count.add += own.add;
    cost.count.mul += own.mul;
    cost.count.div += own.div;
    cost.count.sin_cos += own.sin_cos;
    live = std::max(live, static_cast<int>(count_stack_values(program, false)));
  }
  cost.values += live;
  return cost;
}

namespace {

/// Numbers of TlLimitProgram of runtime/emitted, and the matrices that it takes.
int count_values(const LimitFacts& facts, int velocities, int n, int m) {
  const int V = velocities;
  const int P = core::one_or(static_cast<int>(facts.passive.size()));
  const int H = core::one_or(static_cast<int>(facts.force_weights.size()));
  const int T = core::one_or(static_cast<int>(facts.task_weights.size()));
  const bool shares = facts.has_shares();
  const int cols = core::in_eights(P + H + T + V) + (shares ? core::in_eights(H) : 0);
  const int coordinates = (V + (shares ? H : 0)) * cols + cols + T + H * n;
  const int basis = P * P + H * P + H * H + (shares ? 2 * (H + T) + P + H : H);
  const int rows = 2 * n + m * n + 2 * m;
  const int method = 2 * n * n + 5 * n + m;
  return coordinates + basis + rows + method + V * V + (H + T) * V + V + H;
}

}  // namespace

LimitCost cost_of_limits(const LimitFacts& facts, int velocities) {
  LimitCost cost;
  cost.unknowns = core::in_eights(std::max(facts.freedoms, 1) + 1);
  cost.rows =
      velocities - static_cast<int>(facts.passive.size()) + static_cast<int>(facts.cones.size());
  cost.iterations = 2 * core::most_iterations(cost.unknowns, cost.rows) + cost.unknowns;
  cost.flops_of_iteration = core::flops_of_iteration(cost.unknowns, cost.rows);
  cost.values = count_values(facts, velocities, cost.unknowns, cost.rows);
  return cost;
}

}  // namespace treeline
