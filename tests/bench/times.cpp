#include "times.hpp"

#include <algorithm>
#include <fstream>
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

void add_times(const std::string& path, AllTimes& times) {
  std::ifstream earlier(path);
  for (std::string line; std::getline(earlier, line);) {
    const auto tab = line.find('\t');
    if (tab == std::string::npos) continue;
    times[line.substr(tab + 1)].repetitions.push_back(std::stod(line));
  }
  earlier.close();
  std::ofstream all(path);
  for (const auto& [name, each] : times) {
    for (const double time : each.repetitions) all << time << '\t' << name << '\n';
  }
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
