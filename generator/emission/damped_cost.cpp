#include "emission/damped_cost.hpp"

#include <algorithm>
#include <array>

#include "core/symmetric_eigen.hpp"
#include "emission/describe_program.hpp"
#include "passes/count_operations.hpp"

namespace treeline {
namespace {

/// Adds so many times these operations.
void add(OperationCount& count, int times, int additions, int products, int quotients) {
  count.add += times * additions;
  count.mul += times * products;
  count.div += times * quotients;
}

}  // namespace

bool is_called_by_damped(const std::string& function) {
  constexpr std::array kCalled = {"lambda_inverse", "jacobian", "bias_acceleration",
                                  "inverse_dynamics"};
  return std::find(kCalled.begin(), kCalled.end(), function) != kCalled.end();
}

DampedCost cost_of_damped_solve(int n, int velocities, bool single_precision) {
  const int pairs = n * (n - 1) / 2;
  const int sweeps =
      single_precision ? core::jacobi_sweeps<float>(n) : core::jacobi_sweeps<double>(n);
  const int rotations = sweeps * pairs;
  DampedCost cost;
  OperationCount& count = cost.count;
  cost.square_roots = n + 2 * rotations;
  add(count, n, 1 + velocities, velocities, 0);          // F = xdd_cmd - bias - J qdd_0
  add(count, n * (n + 1) / 2, 0, 2, 0);                  // S Lambda^-1 S
  add(count, rotations, 4, 5, 2);                        // sine and cosine of a rotation
  add(count, rotations * 3 * n, 2, 4, 0);                // its rows and columns
  add(count, 1, 0, 2, 0);                                // border
  add(count, n, 1, 3, 1);                                // delta of each ease
  add(count, n * n * n, 1, 2, 2);                        // A += Delta
  add(count, pairs, 1, 2, 1);                            // pivots of L D L^T, and L
  add(count, n * (n - 1) * (n - 2) / 6, 1, 1, 0);        // what is below them
  add(count, pairs, 2, 2, 0);                            // both triangles
  add(count, n, 0, 0, 1);                                // and D
  add(count, n * velocities, 1, 1, 0);                   // tau += J^T F
  cost.values = 4 * n * n + n * velocities + 6 * n + 8;  // of which 8 in a rotation
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
    live = std::max(live, count_live_values(program));
  }
  cost.values += live;
  return cost;
}

}  // namespace treeline
