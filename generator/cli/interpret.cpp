#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/read_inputs.hpp"
#include "cli/stepped_robot.hpp"
#include "functions/function.hpp"
#include "generation/describe_scene.hpp"
#include "mechanism/home_of.hpp"
#include "oracle/interpreted_robot.hpp"
#include "terminal/exit_code.hpp"
#include "terminal/print_diagnostics.hpp"
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

Json describe_messages(const std::vector<Diagnostic>& messages) {
  Json told = Json::array();
  for (const Diagnostic& each : messages) {
    told.push_back({{"severity", severity_name(each.severity)}, {"text", to_string(each)}});
  }
  return told;
}

/// What calls are answered from.
struct Session {
  const RobotAndScene& inputs;
  Warnings warnings;
  InterpretedRobot robot;
  std::optional<SteppedRobot> stepped;  ///< empty until it is described
};

Json describe_robot(Session& session, const std::vector<Diagnostic>& messages) {
  const RobotAndScene& inputs = session.inputs;
  InterpretedRobot& robot = session.robot;
  const Mechanism& mechanism = robot.mechanism();
  Json coordinates = Json::array(), velocities = Json::array(), functions = Json::array();
  for (const Coordinate& coordinate : mechanism.coordinates) {
    coordinates.push_back({{"joint", coordinate.joint},
                           {"meaning", coordinate.meaning},
                           {"lower", finite(coordinate.lower)},
                           {"upper", finite(coordinate.upper)},
                           {"home", home_of(coordinate)}});
  }
  for (const auto& row : velocity_rows(inputs.robot, mechanism)) {
    velocities.push_back({{"joint", row.joint},
                          {"name", row.name},
                          {"velocity", finite(row.velocity)},
                          {"effort", finite(row.effort)}});
  }
  for (const Function function : robot.functions()) functions.push_back(function_name(function));
  return {{"name", inputs.scene.name},  {"task_rows", mechanism.task_rows()},
          {"coordinates", coordinates}, {"velocities", velocities},
          {"functions", functions},     {"messages", describe_messages(messages)}};
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
bool call(const std::vector<Argument>& arguments, std::size_t states,
          const std::function<std::vector<double>(const std::vector<double>&)>& compute) {
  std::vector<double> numbers(states * count_numbers(arguments));
  const auto bytes = static_cast<std::streamsize>(numbers.size() * sizeof(double));
  if (!std::cin.read(reinterpret_cast<char*>(numbers.data()), bytes)) return false;
  try {
    const std::vector<double> results = compute(numbers);
    std::cout << json_line({{"numbers", results.size()}}) << '\n';
    std::cout.write(reinterpret_cast<const char*>(results.data()),
                    static_cast<std::streamsize>(results.size() * sizeof(double)));
    std::cout.flush();
  } catch (const std::exception& error) {
    answer({{"error", error.what()}});
  }
  return true;
}

/// Tells how the robot is moved on, or why it cannot be.
void describe_step(Session& session) {
  Diagnostics diagnostics;
  session.stepped = make_stepped_robot(session.inputs, diagnostics);
  if (!session.stepped) {
    std::string text;
    for (const Diagnostic& each : diagnostics.list()) {
      if (each.severity == Severity::error) text += (text.empty() ? "" : "\n") + to_string(each);
    }
    answer({{"error", text}});
    return;
  }
  answer({{"equation", "moves on through time, on the ground of the scene"},
          {"arguments", to_json(session.stepped->arguments())},
          {"results", to_json(session.stepped->results())},
          {"messages", describe_messages(select_diagnostics(diagnostics, session.warnings))}});
}

/// Settings that can be computed with.
std::optional<StepSettings> read_settings(std::istream& words) {
  StepSettings settings;
  const bool is_read = static_cast<bool>(words >> settings.seconds >> settings.steps >>
                                         std::boolalpha >> settings.stops);
  const bool fits =
      is_read && settings.seconds > 0 && std::isfinite(settings.seconds) && settings.steps > 0;
  return fits ? std::optional(settings) : std::nullopt;
}

/// Answers a line of the input. False where what follows it cannot be told.
bool obey(Session& session, const std::string& line) {
  std::istringstream words(line);
  std::string verb, name, count;
  words >> verb >> name >> count;
  const bool describes = verb == "describe";
  const auto states = read_count(count);
  if (describes || (verb == "call" && states)) {
    if (const auto function = find_named(session.robot, name)) {
      const InterpretedFunction& described = session.robot.describe(*function);
      if (describes) return answer(describe_function(described)), true;
      return call(described.arguments, *states, [&](const auto& numbers) {
        return session.robot.call(described, *states, numbers);
      });
    }
    if (describes && name == "step") return describe_step(session), true;
    const auto settings = read_settings(words);
    if (name == "step" && session.stepped && settings) {
      return call(session.stepped->arguments(), *states, [&](const auto& numbers) {
        return session.stepped->step(*settings, *states, numbers);
      });
    }
  }
  answer({{"error", fmt::format("cannot be understood: {}", line)}});
  return false;
}

int run(const InputOptions& options) {
  Diagnostics diagnostics;
  const auto inputs = read_inputs(options, diagnostics);
  if (!inputs) {
    print_diagnostics(diagnostics, options.warnings);
    return kBadInput;
  }
  note_differences(inputs->scene, diagnostics);
  Session session{*inputs, options.warnings, {inputs->robot, inputs->scene}, std::nullopt};
  answer(describe_robot(session, select_diagnostics(diagnostics, options.warnings)));
  for (std::string line; std::getline(std::cin, line);) {
    if (!obey(session, line)) return kBadInput;
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
      "...}\n"
      "  call step N SECONDS STEPS STOPS\n"
      "                      the same, once it was described: moves the robot on by so many "
      "steps,\n"
      "                      on the ground of the scene; STOPS is true or false");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace treeline
