#include "generation/choose_loops.hpp"

#include <fmt/format.h>

#include <utility>

#include "description/follow_target.hpp"
#include "passes/count_operations.hpp"
#include "program/link_loops.hpp"
#include "recursion/routes/trace_loops.hpp"
#include "target/target.hpp"

namespace treeline {
namespace {

/// Numbers of a row of the table of links.
constexpr double kNumbersOfLink = 22;
constexpr double kNumbersOfDrive = 3;

/// Bytes of code by g++ 12 -Os: of an operation in straight lines, and of the loops, whatever the
/// robot is. Those of a number type that the target computes by calls take more, see `emulates`.
struct SizeModel {
  double operation, motions, inertias, rows;
};

SizeModel model_of(const Scene& scene) {
  const Target& target = *find_target(scene.target);
  if (emulates(target, bytes_of(scene.real))) return {14, 3100, 2600, 2000};
  return {7, 1900, 2200, 1800};
}

double bytes_of_lines(const Scene& scene, const Program& program) {
  return count_operations(program).flops() * model_of(scene).operation;
}

double bytes_of_loops(const Scene& scene, const LinkLoops& loops) {
  const SizeModel model = model_of(scene);
  const double numbers = static_cast<double>(loops.table.links.size()) * kNumbersOfLink +
                         static_cast<double>(loops.table.drives.size()) * kNumbersOfDrive;
  return numbers * bytes_of(scene.real) + model.motions +
         (loops.uses_inertias ? model.inertias : 0) + (loops.uses_rows ? model.rows : 0);
}

}  // namespace

void choose_loops(const Mechanism& mechanism, const Scene& scene, bool always,
                  GeneratedFunction& generated, Diagnostics& diagnostics) {
  TracedLoops traced =
      trace_loops(mechanism, generated.function, generated.program, scene.sin_cos == Sines::given);
  if (!traced.program) {
    if (!always && traced.obstacle.empty()) return;
    diagnostics.add({always ? Severity::error : Severity::note, "", 0,
                     function_name(generated.function),
                     fmt::format("cannot loop over a table of links: {}",
                                 traced.obstacle.empty() ? "it has no such form" : traced.obstacle),
                     always ? "Choose another route." : "It stays as straight lines."});
    return;
  }
  if (!always &&
      bytes_of_loops(scene, *traced.program->loops) >= bytes_of_lines(scene, generated.program)) {
    return;
  }
  const OperationCosts& costs = operation_costs(*find_target(scene.target), bytes_of(scene.real));
  GeneratedFunction loops = generated_from(generated.function, std::move(*traced.program), costs);
  loops.rejected = std::move(generated.rejected);
  loops.rejected.insert(loops.rejected.begin(), std::move(generated.chosen));
  generated = std::move(loops);
}

}  // namespace treeline
