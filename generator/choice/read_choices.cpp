#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "choice/choices.hpp"
#include "description/suggestions.hpp"
#include "functions/function.hpp"
#include "text/read_text_file.hpp"

namespace treeline {
namespace {

using Json = nlohmann::json;

constexpr std::array kLanes = {0, 1, 2, 4, 8};
constexpr std::string_view kBatch = "batch_";

/// Adds one row to the choices and returns the fault in it; empty: none.
std::string read_row(const Json& row, Choices& choices) {
  const Json chosen = row.value("chosen", Json());
  if (!chosen.is_object()) return "a row of `choices` does not say what is chosen";
  const std::string name = row.value("function", "");
  const bool batch = name.starts_with(kBatch);
  const auto function = find_function(batch ? name.substr(kBatch.size()) : name);
  if (!function) return fmt::format("`{}` is no function: {}", name, suggest_function(name));
  const std::string words = chosen.value("method", "");
  RouteChoice choice{chosen.value("route", words), chosen.value("lanes", 0)};
  if (std::find(kLanes.begin(), kLanes.end(), choice.lanes) == kLanes.end()) {
    return fmt::format("{} lanes of `{}` are none of 1, 2, 4, 8", choice.lanes, name);
  }
  if (batch && choice.lanes != 0) return fmt::format("`{}` has its states for lanes", name);
  (batch ? choices.batch : choices.plain)[*function] = std::move(choice);
  return "";
}

}  // namespace

std::optional<Choices> read_choices(const std::string& path, const std::string& robot,
                                    Diagnostics& diagnostics) {
  const auto text = read_text_file(path, diagnostics);
  if (!text) return std::nullopt;
  std::string fault;
  std::string made_for = robot;
  Choices choices;
  try {
    const Json manifest = Json::parse(*text);
    choices.measured = manifest.value("measured", "");
    made_for = manifest.value("robot", robot);
    for (const Json& row : manifest.at("choices")) {
      if (fault.empty()) fault = read_row(row, choices);
    }
  } catch (const Json::parse_error& error) {
    fault = fmt::format("this is not JSON, from byte {} on", error.byte);
  } catch (const Json::exception&) {
    fault = "there is no list of rows that say what is chosen";
  }
  if (fault.empty() && made_for == robot) return choices;
  if (fault.empty()) {
    diagnostics.add(
        {Severity::error, path, 0, "robot",
         fmt::format("these choices are for the robot \"{}\", not for \"{}\"", made_for, robot),
         "Name the manifest.json of a folder that was generated for this robot."});
    return std::nullopt;
  }
  diagnostics.add({Severity::error, path, 0, "choices", std::move(fault),
                   "Name the manifest.json of a generated folder."});
  return std::nullopt;
}

}  // namespace treeline
