#include "timing/time_cold_calls.hpp"

#include <algorithm>
#include <chrono>

namespace treeline {
namespace {

using Clock = std::chrono::steady_clock;

/// Nanoseconds that `run` takes, with those of reading the clock.
template <class Run>
double time_once(const Run& run) {
  (void)Clock::now();  // brings the clock's own code back
  const auto start = Clock::now();
  run();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

double time_nothing() {
  std::vector<double> times;
  for (int i = 0; i < 101; ++i) times.push_back(time_once([] {}));
  std::nth_element(times.begin(), times.begin() + 50, times.end());
  return times[50];
}

/// Times of one call, by round.
struct Times {
  std::vector<double> from_cache, from_memory;
};

void time_round(const ColdCall& cold, std::size_t round, double nothing, Times& times) {
  const CallArguments& arguments = *cold.call.arguments;
  const std::size_t state = round % arguments.calls();
  const auto time = [&] {
    const double taken = time_once([&] { cold.call.entry(arguments.in(state), arguments.out()); });
    return std::max(0.1, taken - nothing);
  };
  evict_from_core();
  times.from_cache.push_back(time());
  if (!evict_from_caches(arguments.bytes_of(state), {&cold.library, 1})) return;
  times.from_memory.push_back(time());
}

}  // namespace

std::vector<ColdTiming> time_cold_calls(const std::vector<ColdCall>& calls, int rounds) {
  const double nothing = time_nothing();
  std::vector<Times> times(calls.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t k = 0; k < calls.size(); ++k) {
      const std::size_t i = (k + static_cast<std::size_t>(round)) % calls.size();
      time_round(calls[i], static_cast<std::size_t>(round), nothing, times[i]);
    }
  }
  std::vector<ColdTiming> timings;
  for (const Times& each : times) {
    ColdTiming& timing = timings.emplace_back();
    timing.from_cache = summarise_times(each.from_cache, times.front().from_cache);
    if (each.from_memory.empty() || times.front().from_memory.empty()) continue;
    timing.from_memory = summarise_times(each.from_memory, times.front().from_memory);
  }
  return timings;
}

}  // namespace treeline
