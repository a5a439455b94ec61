#include <nlohmann/json.hpp>

#include "bench_robots.hpp"
#include "report.hpp"

namespace treeline::bench {
namespace {

using Json = nlohmann::ordered_json;

void add_facts(const Row& row, Json& line) {
  const Facts& f = row.facts;
  if (!f.method.empty()) line["method"] = f.method;
  line["flops"] = f.flops;
  line["divisions"] = f.divisions;
  line["flops_a_cycle"] = row.flops_a_cycle;
  line["code_bytes_a_cycle"] = row.code_a_cycle;
  line["code_bytes"] = f.code_bytes;
  line["stack_bytes"] = f.stack_bytes;
  line["compile_seconds"] = f.compile_seconds;
  line["compile_mib"] = f.compile_mib;
}

Json describe(const Machine& machine) {
  const Limits& l = machine.limits;
  return {{"processor", machine.processor},
          {"caches", machine.caches},
          {"gigahertz", l.gigahertz},
          {"mul_add_flops_a_cycle", l.mul_add},
          {"scalar_fma_flops_a_cycle", l.scalar_fma},
          {"packed_fma_flops_a_cycle", l.packed_fma},
          {"near_code_bytes_a_cycle", l.near_code},
          {"far_code_bytes_a_cycle", l.far_code},
          {"build", kBuild}};
}

}  // namespace

std::string print_json_lines(const std::vector<Row>& rows, const Machine& machine) {
  std::string text = Json{{"machine", describe(machine)}}.dump() + '\n';
  for (const Row& row : rows) {
    Json line{{"robot", row.measured->robot.robot},
              {"function", name_of(row.function)},
              {"implementation", row.subject->implementation}};
    for (const Mode mode : kModes) {
      if (const auto& median = row.time(mode, false)) {
        line[name_of(mode) + "_ns"] = *median;
        line[name_of(mode) + "_least_ns"] = *row.time(mode, true);
      }
    }
    if (row.instructions > 0) line["instructions"] = row.instructions;
    if (!row.subject->facts.empty()) add_facts(row, line);
    text += line.dump() + '\n';
  }
  return text;
}

}  // namespace treeline::bench
