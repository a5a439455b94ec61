#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "text/align_columns.hpp"
#include "timing/tune.hpp"

namespace treeline {
namespace {

/// Indices of the trials, fastest first.
std::vector<std::size_t> rank(const TunedFunction& tuned) {
  std::vector<std::size_t> order(tuned.trials.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return tuned.trials[a].measured.ratio < tuned.trials[b].measured.ratio;
  });
  return order;
}

std::string print_lanes(const Trial& trial) {
  return trial.choice.lanes > 0 ? std::to_string(trial.choice.lanes) : "";
}

/// Columns of a trial.
std::vector<std::string> print_trial(const TunedFunction& tuned, std::size_t i) {
  const Trial& trial = tuned.trials[i];
  const Timing& measured = trial.measured;
  const char* note = i == tuned.fastest ? " <- chosen" : i == 0 ? " <- least cost" : "";
  return {fmt::format("{:.1f}", measured.nanoseconds),
          fmt::format("{:.3f}", measured.ratio),
          fmt::format("{:.3f}", measured.noise),
          std::to_string(trial.count.flops()),
          print_lanes(trial),
          trial.choice.route + note};
}

nlohmann::ordered_json describe_trial(const TunedFunction& tuned, std::size_t i) {
  const Trial& trial = tuned.trials[i];
  nlohmann::ordered_json json = {{"function", source_stem(tuned.function, tuned.batch)},
                                 {"route", trial.choice.route},
                                 {"lanes", nullptr},
                                 {"flops", trial.count.flops()},
                                 {"nanoseconds", trial.measured.nanoseconds},
                                 {"ratio", trial.measured.ratio},
                                 {"noise", trial.measured.noise},
                                 {"least_cost", i == 0},
                                 {"chosen", i == tuned.fastest}};
  if (trial.choice.lanes > 0) json["lanes"] = trial.choice.lanes;
  return json;
}

}  // namespace

std::string print_text(const Tuning& tuning) {
  std::vector<std::vector<std::string>> rows;
  for (const TunedFunction& tuned : tuning.functions) {
    std::string name = source_stem(tuned.function, tuned.batch);
    for (const std::size_t i : rank(tuned)) {
      rows.push_back(print_trial(tuned, i));
      rows.back().insert(rows.back().begin(), std::exchange(name, ""));
    }
  }
  return tuning.measured + "\n" +
         align_columns({{"function"},
                        {"ns", true},
                        {"ratio", true},
                        {"noise", true},
                        {"flops", true},
                        {"lanes", true},
                        {"route"}},
                       rows) +
         "\n";
}

nlohmann::ordered_json to_json(const Tuning& tuning) {
  auto trials = nlohmann::ordered_json::array();
  for (const TunedFunction& tuned : tuning.functions) {
    for (const std::size_t i : rank(tuned)) trials.push_back(describe_trial(tuned, i));
  }
  return trials;
}

}  // namespace treeline
