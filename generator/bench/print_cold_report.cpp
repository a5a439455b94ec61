#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/cold_report.hpp"
#include "description/scene_words.hpp"
#include "text/align_columns.hpp"
#include "text/json_text.hpp"

namespace treeline {
namespace {

using Json = nlohmann::ordered_json;

/// A time and its ratio; blanks where it was not measured.
void append_timing(const std::optional<Timing>& timing, std::vector<std::string>& cells) {
  cells.push_back(timing ? print_time(timing->nanoseconds) : "");
  cells.push_back(timing ? fmt::format("{:.2f}", timing->ratio) : "");
}

std::string print_cold_function(const ColdFunction& function) {
  std::vector<std::vector<std::string>> rows;
  for (const ColdRow& row : function.rows) {
    std::vector<std::string>& cells =
        rows.emplace_back(std::vector{row.bytes ? std::to_string(*row.bytes) : ""});
    append_timing(row.warm, cells);
    cells.push_back(print_time(row.cold.from_cache.nanoseconds));
    append_timing(row.cold.from_memory, cells);
    for (const std::string& word :
         {std::string(row.is_small ? "-Os" : ""), names_of(row), row.method}) {
      cells.push_back(word);
    }
  }
  return std::string(function_name(function.function)) + "\n" +
         align_columns({{"bytes", true},
                        {"warm ns", true},
                        {"ratio", true},
                        {"from cache", true},
                        {"from memory", true},
                        {"ratio", true},
                        {"flag"},
                        {"optimize"},
                        {"by"}},
                       rows) +
         "\n";
}

Json describe_timing(const std::optional<Timing>& timing) {
  if (!timing) return nullptr;
  return {{"nanoseconds", timing->nanoseconds}, {"ratio", timing->ratio}, {"noise", timing->noise}};
}

Json describe_cold_row(const ColdReport& report, const ColdFunction& function, const ColdRow& row) {
  Json optimize = Json::array();
  for (const Optimize each : row.optimize) optimize.push_back(word_of(each));
  return {{"scene", report.name},
          {"function", function_name(function.function)},
          {"optimize", optimize},
          {"method", row.method},
          {"small", row.is_small},
          {"bytes", row.bytes ? Json(*row.bytes) : Json(nullptr)},
          {"warm", describe_timing(row.warm)},
          {"from_cache", describe_timing(row.cold.from_cache)},
          {"from_memory", describe_timing(row.cold.from_memory)}};
}

}  // namespace

std::string print_table(const ColdReport& report) {
  std::string text = fmt::format(
      "{}: bytes, and time of a call whose code is in caches or not, by `optimize`\n"
      "on {}\ncompiled by {}\n       with {}\n\n",
      report.name, report.machine.processor, report.machine.compiler, report.machine.command);
  for (const ColdFunction& function : report.functions) text += print_cold_function(function);
  return text;
}

std::string print_json_lines(const ColdReport& report) {
  std::string text = json_line({{"scene", report.name},
                                {"robot", report.robot},
                                {"processor", report.machine.processor},
                                {"compiler", report.machine.compiler},
                                {"command", report.machine.command}}) +
                     "\n";
  for (const ColdFunction& function : report.functions) {
    for (const ColdRow& row : function.rows) {
      text += json_line(describe_cold_row(report, function, row)) + "\n";
    }
  }
  return text;
}

}  // namespace treeline
