#include "times.hpp"

#include <algorithm>
#include <ostream>

namespace treeline::bench {

double Times::median() const {
  auto sorted = repetitions;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t n = sorted.size();
  return n == 0 ? 0 : (sorted[(n - 1) / 2] + sorted[n / 2]) / 2;
}

double Times::least() const {
  return *std::min_element(repetitions.begin(), repetitions.end());
}

void Collector::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.error_occurred) {
      GetErrorStream() << run.benchmark_name() << ": " << run.error_message << '\n';
    } else if (run.run_type == Run::RT_Iteration) {
      times[run.run_name.function_name].repetitions.push_back(run.GetAdjustedRealTime());
    }
  }
}

}  // namespace treeline::bench
