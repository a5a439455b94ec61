#include "timing/time_calls.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace treeline {
namespace {

using Clock = std::chrono::steady_clock;

/// Runs `passes` passes. Returns nanoseconds per call.
double repeat(const TimedPass& timed, int passes) {
  const auto start = Clock::now();
  for (int pass = 0; pass < passes; ++pass) timed.pass();
  const std::chrono::duration<double, std::nano> taken = Clock::now() - start;
  return taken.count() / (static_cast<double>(passes) * static_cast<double>(timed.calls));
}

/// Number of passes for one repetition, measured once code and data are in the caches.
int count_passes(const TimedPass& timed, const TimingOptions& options) {
  repeat(timed, 1);
  const double pass = std::max(1.0, repeat(timed, 1) * static_cast<double>(timed.calls));
  return std::max(1, static_cast<int>(std::ceil(1000 * options.repetition_us / pass)));
}

/// One pass through all states.
TimedPass pass_of(const TimedCall& call) {
  const auto pass = [call] {
    const std::size_t states = call.arguments->calls();
    for (std::size_t i = 0; i < states; ++i) {
      call.entry(call.arguments->in(i), call.arguments->out());
    }
  };
  return {pass, call.arguments->calls()};
}

/// Value below which the given share of `values` lies.
double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

}  // namespace

Timing summarise_times(const std::vector<double>& times, const std::vector<double>& first) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < times.size(); ++round) {
    ratios.push_back(times[round] / first[round]);
  }
  return {quantile(times, 0.5), quantile(ratios, 0.5),
          (quantile(ratios, 0.75) - quantile(ratios, 0.25)) / 2};
}

std::vector<Timing> time_passes(const std::vector<TimedPass>& passes,
                                const TimingOptions& options) {
  if (passes.empty()) return {};
  std::vector<int> counts;
  for (const TimedPass& timed : passes) counts.push_back(count_passes(timed, options));
  std::vector<std::vector<double>> times(passes.size());
  for (int round = 0; round < options.rounds; ++round) {
    for (std::size_t k = 0; k < passes.size(); ++k) {
      const std::size_t i = (k + static_cast<std::size_t>(round)) % passes.size();
      repeat(passes[i], 1);  // brings back into the caches what others displaced
      times[i].push_back(repeat(passes[i], counts[i]));
    }
  }
  std::vector<Timing> timings;
  for (const auto& each : times) timings.push_back(summarise_times(each, times.front()));
  return timings;
}

std::vector<Timing> time_calls(const std::vector<TimedCall>& calls, const TimingOptions& options) {
  std::vector<TimedPass> passes;
  for (const TimedCall& call : calls) passes.push_back(pass_of(call));
  return time_passes(passes, options);
}

}  // namespace treeline
