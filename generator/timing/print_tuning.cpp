#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "emission/print_manifest.hpp"
#include "timing/tune.hpp"

namespace treeline {
namespace {

/// Indices of the trials, fastest first.
std::vector<std::size_t> rank(const TunedFunction& tuned) {
  std::vector<std::size_t> order(tuned.trials.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return tuned.trials[a].timing.ratio < tuned.trials[b].timing.ratio;
  });
  return order;
}

std::string print_lanes(const Trial& trial) {
  return trial.choice.lanes > 0 ? std::to_string(trial.choice.lanes) : "";
}

std::string print_trial(const TunedFunction& tuned, std::size_t i) {
  const Trial& trial = tuned.trials[i];
  return fmt::format(
      R"({{"function": {}, "route": {}, "lanes": {}, "flops": {}, )"
      R"("nanoseconds": {:.4g}, "ratio": {:.4f}, "noise": {:.4f}, )"
      R"("least_cost": {}, "chosen": {}}})",
      quote_json(source_stem(tuned.function, tuned.batch)), quote_json(trial.choice.route),
      trial.choice.lanes > 0 ? std::to_string(trial.choice.lanes) : "null", trial.count.flops(),
      trial.timing.nanoseconds, trial.timing.ratio, trial.timing.noise, i == 0, i == tuned.fastest);
}

}  // namespace

std::string print_text(const Tuning& tuning) {
  std::string text = fmt::format("{}\n{:<28} {:>9} {:>6} {:>6} {:>6} {:>5}  {}\n", tuning.measured,
                                 "function", "ns", "ratio", "noise", "flops", "lanes", "route");
  for (const TunedFunction& tuned : tuning.functions) {
    std::string name = source_stem(tuned.function, tuned.batch);
    for (const std::size_t i : rank(tuned)) {
      const Trial& trial = tuned.trials[i];
      const char* note = i == tuned.fastest ? " <- chosen" : i == 0 ? " <- least cost" : "";
      text += fmt::format("{:<28} {:>9.1f} {:>6.3f} {:>6.3f} {:>6} {:>5}  {}{}\n", name,
                          trial.timing.nanoseconds, trial.timing.ratio, trial.timing.noise,
                          trial.count.flops(), print_lanes(trial), trial.choice.route, note);
      name.clear();
    }
  }
  return text + "\n";
}

std::string print_json(const Tuning& tuning) {
  std::string trials;
  for (const TunedFunction& tuned : tuning.functions) {
    for (const std::size_t i : rank(tuned)) {
      trials += (trials.empty() ? "" : ",\n    ") + print_trial(tuned, i);
    }
  }
  return fmt::format("[\n    {}\n  ]", trials);
}

}  // namespace treeline
