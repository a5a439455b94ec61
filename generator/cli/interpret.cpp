#include "cli/interpret.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "cli/exit_code.hpp"
#include "cli/print_diagnostics.hpp"
#include "cli/read_inputs.hpp"
#include "functions/function.hpp"
#include "mechanism/home_of.hpp"
#include "oracle/interpreted_robot.hpp"
#include "text/json_text.hpp"

namespace treeline {
namespace {

using Json = nlohmann::ordered_json;

/// The most states of a call, and so that no request asks for more memory than there may be.
constexpr std::size_t kMostStates = 1 << 20;

/// Null where there is no limit.
Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// Notes where the interpreter differs from the scene.
void note_differences(const Scene& scene, Diagnostics& diagnostics) {
  const auto note = [&](const char* element, const char* fault) {
    diagnostics.add({Severity::note, scene.file, 0, element, fault, ""});
  };
  if (scene.real == Real::float32) note("real", "the interpreter computes in double");
  if (scene.sin_cos == Sines::given) note("sin_cos", "interpreted functions take q alone");
}

Json describe_robot(const Scene& scene, InterpretedRobot& robot,
                    const std::vector<Diagnostic>& messages) {
  const Mechanism& mechanism = robot.mechanism();
  Json coordinates = Json::array(), functions = Json::array(), told = Json::array();
  for (const Diagnostic& each : messages) {
    told.push_back({{"severity", severity_name(each.severity)}, {"text", to_string(each)}});
  }
  for (const Coordinate& coordinate : mechanism.coordinates) {
    coordinates.push_back({{"joint", coordinate.joint},
                           {"meaning", coordinate.meaning},
                           {"lower", finite(coordinate.lower)},
                           {"upper", finite(coordinate.upper)},
                           {"home", home_of(coordinate)}});
  }
  for (const Function function : robot.functions()) functions.push_back(function_name(function));
  return {{"name", scene.name},         {"task_rows", mechanism.task_rows()},
          {"coordinates", coordinates}, {"velocities", mechanism.velocities},
          {"functions", functions},     {"messages", told}};
}

Json to_json(const std::vector<Argument>& list) {
  Json json = Json::array();
  for (const Argument& each : list) {
    json.push_back(
        {{"name", each.name}, {"rows", each.rows}, {"cols", each.cols}, {"meaning", each.meaning}});
  }
  return json;
}

Json describe_function(const InterpretedFunction& function) {
  return {{"equation", function.equation},
          {"arguments", to_json(function.arguments)},
          {"results", to_json(function.results)}};
}

/// The function of the scene that has this name.
std::optional<Function> find_named(const InterpretedRobot& robot, const std::string& name) {
  const auto& functions = robot.functions();
  const auto found = std::find_if(functions.begin(), functions.end(), [&](Function function) {
    return name == function_name(function);
  });
  return found == functions.end() ? std::nullopt : std::optional(*found);
}

std::optional<std::size_t> read_count(const std::string& text) {
  std::size_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  const bool is_whole = error == std::errc() && end == text.data() + text.size();
  return is_whole && count <= kMostStates ? std::optional(count) : std::nullopt;
}

void answer(const Json& json) {
  std::cout << json_line(json) << '\n' << std::flush;
}

/// Reads the numbers of a call and answers with those of its results. False at the input's end.
bool call(const InterpretedRobot& robot, const InterpretedFunction& function, std::size_t states) {
  std::vector<double> numbers(states * count_numbers(function.arguments));
  const auto bytes = static_cast<std::streamsize>(numbers.size() * sizeof(double));
  if (!std::cin.read(reinterpret_cast<char*>(numbers.data()), bytes)) return false;
  try {
    const std::vector<double> results = robot.call(function, states, numbers);
    std::cout << json_line({{"numbers", results.size()}}) << '\n';
    std::cout.write(reinterpret_cast<const char*>(results.data()),
                    static_cast<std::streamsize>(results.size() * sizeof(double)));
    std::cout.flush();
  } catch (const std::exception& error) {
    answer({{"error", error.what()}});
  }
  return true;
}

/// Answers a line of the input. False where what follows it cannot be told.
bool obey(InterpretedRobot& robot, const std::string& line) {
  std::istringstream words(line);
  std::string verb, name, count;
  words >> verb >> name >> count;
  const auto function = find_named(robot, name);
  const auto states = read_count(count);
  const bool is_call = verb == "call" && states;
  if (!function || !(is_call || verb == "describe")) {
    answer({{"error", fmt::format("cannot be understood: {}", line)}});
    return false;
  }
  const InterpretedFunction& described = robot.describe(*function);
  if (is_call) return call(robot, described, *states);
  answer(describe_function(described));
  return true;
}

int run(const InputOptions& options) {
  Diagnostics diagnostics;
  const auto inputs = read_inputs(options, diagnostics);
  if (!inputs) {
    print_diagnostics(diagnostics, options.warnings);
    return kBadInput;
  }
  note_differences(inputs->scene, diagnostics);
  InterpretedRobot robot(inputs->robot, inputs->scene);
  answer(describe_robot(inputs->scene, robot, select_diagnostics(diagnostics, options.warnings)));
  for (std::string line; std::getline(std::cin, line);) {
    if (!obey(robot, line)) return kBadInput;
  }
  return kOk;
}

}  // namespace

void add_interpret(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<InputOptions>();
  CLI::App* command =
      app.add_subcommand("interpret", "Answer calls of a robot's functions, without its code");
  add_input_options(*command, *options);
  command->footer(
      "For programs: `treeline.Model` of Python is one. Numbers are computed in double by the\n"
      "interpreter that `check` compares with. The first line of the output, in JSON, describes\n"
      "the robot and tells the messages. Then each line of the input is answered:\n"
      "  describe FUNCTION   arguments and results: a line of JSON\n"
      "  call FUNCTION N     and behind the line the arguments of N states, one state after the\n"
      "                      other, as doubles of this machine: {\"numbers\": COUNT} and as many\n"
      "                      doubles, the results of one state after the other; or {\"error\": "
      "...}");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace treeline
