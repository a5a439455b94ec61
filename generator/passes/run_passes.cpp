#include <fmt/format.h>

#include <array>
#include <utility>

#include "passes/count_operations.hpp"
#include "passes/passes.hpp"

namespace treeline {
namespace {

struct Pass {
  const char* name;
  Program (*run)(const Program&);
};

constexpr std::array kReducing = {
    Pass{"canonicalize", canonicalize}, Pass{"factor_sums", factor_sums},
    Pass{"share_pairs", share_pairs},   Pass{"eliminate_dead", eliminate_dead},
    Pass{"pack_lanes", pack_lanes},
};

/// Runs one pass and appends its report to `log`. `count` has the operations of the program before
/// the pass, and then those after it.
Program run(const Pass& pass, const Program& program, OperationCount& count,
            std::vector<PassReport>& log) {
  Program after = pass.run(program);
  const OperationCount before = std::exchange(count, count_operations(after));
  log.push_back(
      {pass.name, before, count, program.graph.nodes().size(), after.graph.nodes().size()});
  return after;
}

}  // namespace

Program reduce_operations(Program program, std::vector<PassReport>& log) {
  OperationCount count = count_operations(program);
  for (const Pass& pass : kReducing) {
    program = run(pass, program, count, log);
  }
  return program;
}

Program put_in_order(const Program& program, std::vector<PassReport>& log) {
  OperationCount count = count_operations(program);
  return run({"schedule", schedule}, program, count, log);
}

std::string to_string(const std::string& function, const PassReport& report) {
  return fmt::format("{}: {} {} -> {} flops, {} -> {} nodes", function, report.pass,
                     report.before.flops(), report.after.flops(), report.nodes_before,
                     report.nodes_after);
}

}  // namespace treeline
