#include "timing/time_calls.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace treeline {
namespace {

using Clock = std::chrono::steady_clock;

/// So many times through all states; nanoseconds a call.
double repeat(const TimedCall& call, int passes) {
  const std::size_t states = call.arguments->calls();
  const auto start = Clock::now();
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t i = 0; i < states; ++i) {
      call.entry(call.arguments->in(i), call.arguments->out());
    }
  }
  const std::chrono::duration<double, std::nano> taken = Clock::now() - start;
  return taken.count() / (static_cast<double>(passes) * static_cast<double>(states));
}

/// Enough passes for a repetition, once code and data are where they will be.
int count_passes(const TimedCall& call, const TimingOptions& options) {
  repeat(call, 1);
  const double pass = std::max(1.0, repeat(call, 1) * static_cast<double>(call.arguments->calls()));
  return std::max(1, static_cast<int>(std::ceil(1000 * options.repetition_us / pass)));
}

/// The value below which a share of `values` lies.
double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

Timing summarise(const std::vector<double>& times, const std::vector<double>& first) {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < times.size(); ++round) {
    ratios.push_back(times[round] / first[round]);
  }
  return {quantile(times, 0.5), quantile(ratios, 0.5),
          (quantile(ratios, 0.75) - quantile(ratios, 0.25)) / 2};
}

}  // namespace

std::vector<Timing> time_calls(const std::vector<TimedCall>& calls, const TimingOptions& options) {
  if (calls.empty()) return {};
  std::vector<int> passes;
  for (const TimedCall& call : calls) passes.push_back(count_passes(call, options));
  std::vector<std::vector<double>> times(calls.size());
  for (int round = 0; round < options.rounds; ++round) {
    for (std::size_t k = 0; k < calls.size(); ++k) {
      const std::size_t i = (k + static_cast<std::size_t>(round)) % calls.size();
      repeat(calls[i], 1);  // brings back what the others pushed out of the caches
      times[i].push_back(repeat(calls[i], passes[i]));
    }
  }
  std::vector<Timing> timings;
  for (const auto& each : times) timings.push_back(summarise(each, times.front()));
  return timings;
}

}  // namespace treeline
