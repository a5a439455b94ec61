#include "generation/choose_loops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "description/follow_target.hpp"
#include "passes/count_operations.hpp"
#include "passes/take_sines.hpp"
#include "program/link_loops.hpp"
#include "recursion/routes/trace_loops.hpp"
#include "target/target.hpp"

namespace treeline {
namespace {

/// Numbers of a row of the table of links.
constexpr double kNumbersOfLink = 21;
constexpr double kNumbersOfFrame = 12;
constexpr double kNumbersOfDrive = 3;
constexpr double kNumbersOfFriction = 2;
constexpr double kNumbersOfCoupling = 2;
constexpr double kBytesOfCall = 120;   // of a function of the loops
constexpr double kBytesOfInput = 250;  // of what each argument adds that changes the table
constexpr double kWorthwhile = 0.9;    // of the bytes of straight lines, which are estimated too

/// Bytes of code by g++ 12 -Os: of an operation in straight lines and of sines and cosines, and of
/// the loops, whatever the robot is. Those of a number type that the target computes by calls take
/// more, see `emulates`.
struct SizeModel {
  double operation, sines, motions, inertias, rows;
};

SizeModel model_of(const Scene& scene) {
  const Target& target = *find_target(scene.target);
  if (emulates(target, bytes_of(scene.real))) return {15, 0, 3100, 4350, 1400};
  return {6, 330, 1900, 2750, 1250};
}

double bytes_of_lines(const Scene& scene, int flops) {
  const SizeModel model = model_of(scene);
  return flops * model.operation + model.sines;
}

double bytes_of_loops(const Scene& scene, const LinkLoops& loops) {
  const SizeModel model = model_of(scene);
  const LinkTableData& table = loops.table;
  double numbers = static_cast<double>(table.links.size()) * kNumbersOfLink +
                   static_cast<double>(table.drives.size()) * kNumbersOfDrive +
                   static_cast<double>(table.frictions.size()) * kNumbersOfFriction +
                   static_cast<double>(table.couplings.size()) * kNumbersOfCoupling;
  for (const LinkInput& input : table.inputs) {
    numbers += static_cast<double>(input.frames.size()) * kNumbersOfFrame;
  }
  return numbers * bytes_of(scene.real) + model.motions +
         (loops.uses_inertias ? model.inertias : 0) + (loops.uses_rows ? model.rows : 0) +
         static_cast<double>(table.inputs.size()) * kBytesOfInput;
}

/// With the arguments that it reads.
std::optional<Program> trace(const Mechanism& mechanism, Function function, const Program& lines,
                             bool given_sines) {
  std::optional<Program> traced = trace_loops(mechanism, function, lines, given_sines);
  if (traced) declare_sines(*traced);
  return traced;
}

}  // namespace

void choose_loops(const Mechanism& mechanism, const Scene& scene, bool always,
                  GeneratedFunction& generated, Diagnostics& diagnostics) {
  std::optional<Program> traced =
      trace(mechanism, generated.function, generated.program, scene.sin_cos == Sines::given);
  if (!traced) {
    if (!always) return;
    diagnostics.add({Severity::error, "", 0, generated.program.name,
                     "cannot loop over a table of links: it has no such form",
                     "Choose another route."});
    return;
  }
  const double lines = bytes_of_lines(scene, count_operations(generated.program).flops());
  if (!always && bytes_of_loops(scene, *traced->loops) >= kWorthwhile * lines) return;
  const OperationCosts& costs = operation_costs(*find_target(scene.target), bytes_of(scene.real));
  GeneratedFunction loops = generated_from(generated.function, std::move(*traced), costs);
  loops.rejected = std::move(generated.rejected);
  loops.rejected.insert(loops.rejected.begin(), std::move(generated.chosen));
  generated = std::move(loops);
}

std::vector<Program> choose_loops_together(const Mechanism& mechanism, const Scene& scene,
                                           std::span<const LoopCandidate> candidates) {
  std::vector<Program> programs;
  double lines = 0;
  double loops = 0;  // once for all
  double calls = 0;
  for (const LoopCandidate& each : candidates) {
    std::optional<Program> traced = trace(mechanism, each.function, *each.lines, true);
    if (!traced) return {};
    lines += bytes_of_lines(scene, each.flops);
    loops = std::max(loops, bytes_of_loops(scene, *traced->loops));
    calls += kBytesOfCall;
    programs.push_back(std::move(*traced));
  }
  return loops + calls < kWorthwhile * lines ? std::move(programs) : std::vector<Program>{};
}

}  // namespace treeline
