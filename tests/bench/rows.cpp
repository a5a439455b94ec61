#include "rows.hpp"

#include <algorithm>

namespace treeline::bench {
namespace {

void take_times(const AllTimes& times, Row& row) {
  for (const Mode mode : kModes) {
    const auto found = times.find(row.measured->robot.robot + '/' + name_of(row.function) + '/' +
                                  row.subject->implementation + '/' + name_of(mode));
    if (found == times.end()) continue;
    const auto at = static_cast<std::size_t>(mode);
    row.median[at] = found->second.median();
    row.least[at] = found->second.least();
  }
}

/// Sets the rates achieved in warm calls. The code of a batch runs once for all its states.
void find_rates(const Limits& limits, int states, Row& row) {
  const auto warm = row.time(Mode::warm, false);
  if (!warm || limits.gigahertz <= 0) return;
  const double cycles = *warm * limits.gigahertz;
  row.flops_a_cycle = static_cast<double>(row.facts.flops) / cycles;
  row.code_a_cycle = static_cast<double>(row.facts.code_bytes) / (cycles * states);
}

}  // namespace

std::vector<Row> collect_rows(const std::vector<Measured>& robots, const AllTimes& times,
                              const std::map<std::string, long>& counts, const Limits& limits) {
  std::vector<Row> rows;
  for (const Measured& measured : robots) {
    for (const Function function : kFunctions) {
      for (const Subject& subject : measured.subjects) {
        const auto routine = subject.routines.find(function);
        if (routine == subject.routines.end()) continue;
        Row row{&measured, &subject, function, {}, {}, {}, 0, 0, 0};
        take_times(times, row);
        const auto given = [](const auto& time) { return time.has_value(); };
        if (std::ranges::none_of(row.median, given)) continue;
        if (!subject.facts.empty()) row.facts = read_facts(subject, name_of(function));
        find_rates(limits, routine->second.states, row);
        const auto count = counts.find(measured.robot.robot + '/' + name_of(function));
        const bool counted = subject.implementation.ends_with("x86-64-v3");
        if (counted && count != counts.end()) row.instructions = count->second;
        rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

}  // namespace treeline::bench
