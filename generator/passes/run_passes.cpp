#include "passes/run_passes.hpp"

#include <fmt/format.h>

#include <array>

#include "passes/count_operations.hpp"
#include "passes/eliminate_dead.hpp"
#include "passes/factor_sums.hpp"
#include "passes/pack_lanes.hpp"
#include "passes/schedule.hpp"
#include "passes/settle.hpp"
#include "passes/share_pairs.hpp"

namespace treeline {
namespace {

struct Pass {
  const char* name;
  Program (*run)(const Program&);
};

constexpr std::array kPasses = {
    Pass{"settle", settle},           Pass{"factor_sums", factor_sums},
    Pass{"share_pairs", share_pairs}, Pass{"eliminate_dead", eliminate_dead},
    Pass{"pack_lanes", pack_lanes},   Pass{"schedule", schedule},
};

}  // namespace

Program run_passes(Program program, std::vector<PassReport>& log) {
  for (const Pass& pass : kPasses) {
    const OperationCount before = count_operations(program);
    const std::size_t nodes = program.graph.nodes().size();
    program = pass.run(program);
    log.push_back(
        {pass.name, before, count_operations(program), nodes, program.graph.nodes().size()});
  }
  return program;
}

std::string to_string(const std::string& function, const PassReport& report) {
  return fmt::format("{}: {} {} -> {} flops, {} -> {} nodes", function, report.pass,
                     report.before.flops(), report.after.flops(), report.nodes_before,
                     report.nodes_after);
}

}  // namespace treeline
