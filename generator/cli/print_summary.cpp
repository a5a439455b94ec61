#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/print_outputs.hpp"
#include "passes/count_operations.hpp"
#include "text/align_columns.hpp"
#include "text/json_text.hpp"

namespace treeline {
namespace {

using Json = nlohmann::ordered_json;

const char* to_word(Difference difference) {
  switch (difference) {
    case Difference::missing:
      return "missing";
    case Difference::changed:
      return "changed";
    case Difference::left_over:
      return "left over";
  }
  return "";
}

std::string count_files(std::size_t count) {
  return fmt::format("{} file{}", count, count == 1 ? "" : "s");
}

std::string print_written(const Summary& summary) {
  const auto removed = static_cast<std::size_t>(std::count_if(
      summary.differences.begin(), summary.differences.end(),
      [](const FileDifference& each) { return each.difference == Difference::left_over; }));
  const std::size_t written = summary.differences.size() - removed;
  const std::string changed = written == 0               ? ", none changed"
                              : written == summary.files ? " written"
                                                         : fmt::format(", {} written", written);
  const std::string gone =
      removed == 0 ? "" : fmt::format(", {} of an earlier run removed", removed);
  return fmt::format("{}: {}{}{}\n", summary.output, count_files(summary.files), changed, gone);
}

std::string print_files(const Summary& summary) {
  if (!summary.compared_only) return print_written(summary);
  if (summary.differences.empty()) {
    return fmt::format("{}: up to date\n", summary.output);
  }
  std::string text = fmt::format("{}: not up to date\n", summary.output);
  for (const FileDifference& difference : summary.differences) {
    text += fmt::format("  {}: {}\n", difference.name, to_word(difference.difference));
  }
  return text;
}

Json describe_function(const GeneratedFunction& generated) {
  const OperationCount count = count_operations(generated.program);
  return {{"name", generated.program.name},
          {"route", key_of(generated.chosen.route)},
          {"method", describe(generated.chosen.route)},
          {"cost", std::lround(generated.chosen.weighted)},
          {"flops", count.flops()},
          {"add", count.add},
          {"mul", count.mul},
          {"div", count.div},
          {"sin_cos", count.sin_cos}};
}

}  // namespace

std::string print_text(const Summary& summary) {
  std::vector<std::vector<std::string>> rows;
  for (const GeneratedFunction& generated : summary.functions) {
    const OperationCount count = count_operations(generated.program);
    rows.push_back({generated.program.name, fmt::format("{}", count.flops()),
                    fmt::format("{}", count.add), fmt::format("{}", count.mul),
                    fmt::format("{}", count.div), fmt::format("{}", count.sin_cos),
                    fmt::format("{:.0f}", generated.chosen.weighted),
                    describe(generated.chosen.route)});
    for (const Cost& cost : summary.verbose ? generated.rejected : std::vector<Cost>{}) {
      rows.push_back({"  rejected", fmt::format("{}", cost.count.flops()), "", "", "", "",
                      fmt::format("{:.0f}", cost.weighted),
                      fmt::format("({})", describe(cost.route))});
    }
  }
  return (summary.tuning != nullptr ? print_text(*summary.tuning) : "") +
         align_columns({{"function", false, true},
                        {"flops", true},
                        {"add", true},
                        {"mul", true},
                        {"div", true},
                        {"sin,cos", true},
                        {"cost", true},
                        {"method"}},
                       rows) +
         print_files(summary);
}

std::string print_json(const Summary& summary) {
  Json json;
  if (summary.tuning != nullptr) {
    json["measured"] = summary.tuning->measured;
    json["tuning"] = to_json(*summary.tuning);
  }
  json["output"] = summary.output;
  json["written"] = !summary.compared_only;
  json["functions"] = Json::array();
  for (const GeneratedFunction& generated : summary.functions) {
    json["functions"].push_back(describe_function(generated));
  }
  json["differences"] = Json::array();
  for (const FileDifference& each : summary.differences) {
    json["differences"].push_back({{"file", each.name}, {"difference", to_word(each.difference)}});
  }
  return json_text(json);
}

}  // namespace treeline
