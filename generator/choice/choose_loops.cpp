#include "choice/choose_loops.hpp"

#include <fmt/format.h>

#include <utility>

#include "description/follow_target.hpp"
#include "passes/count_operations.hpp"
#include "passes/passes.hpp"
#include "program/ending.hpp"
#include "program/link_loops.hpp"
#include "recursion/routes/trace_function.hpp"
#include "target/target.hpp"

namespace treeline {
namespace {

constexpr double kBytesOfCall = 120;  // of a function of the loops
constexpr double kWorthwhile = 0.9;   // of the bytes of straight lines, which are estimated too

/// Traces the function as loops, with the arguments that it reads.
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
  LoopNeeds needs;
  needs.add(generated.function, *traced->loops);
  const Program& printed = printed_lines(generated.program);
  const double lines = bytes_of_lines(scene, count_operations(printed).flops());
  if (!always && needs.bytes(scene) >= kWorthwhile * lines) return;
  const OperationCosts& costs = operation_costs(*find_target(scene.target), bytes_of(scene.real));
  GeneratedFunction loops = generated_from(generated.function, std::move(*traced), costs);
  loops.rejected = std::move(generated.rejected);
  loops.rejected.insert(loops.rejected.begin(), std::move(generated.chosen));
  generated = std::move(loops);
}

std::vector<Program> choose_loops_together(const Mechanism& mechanism, const Scene& scene,
                                           std::span<const LoopCandidate> candidates) {
  std::vector<Program> programs;
  int flops = 0;
  LoopNeeds needs;
  double calls = 0;
  for (const LoopCandidate& each : candidates) {
    std::optional<Program> traced = trace(mechanism, each.function, *each.lines, true);
    if (!traced) return {};
    flops += each.flops;
    needs.add(each.function, *traced->loops);
    calls += kBytesOfCall;
    programs.push_back(std::move(*traced));
  }
  return needs.bytes(scene) + calls < kWorthwhile * bytes_of_lines(scene, flops)
             ? std::move(programs)
             : std::vector<Program>{};
}

}  // namespace treeline
