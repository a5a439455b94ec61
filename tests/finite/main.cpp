// Searches robots for finite inputs for which their emitted code is not finite:
//   search_not_finite [--states N] [--first INDEX] [--seed N] [--flags FLAGS] [--base BASE]
//                     [--real float] [--length METRES] (FILE.urdf [SCENE.yaml])...
// with the scene after the file, or those that `init-scene` proposes for either base. Prints a line
// for each robot and base. Exit status: 0 all finite, 1 something was not finite or could not be
// made, 2 usage.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "finite/search.hpp"

namespace {

using namespace treeline;         // NOLINT: a program, not a header
using namespace treeline::tests;  // NOLINT

struct Files {
  std::string urdf, scene;  ///< no scene: those that `init-scene` proposes
};

struct Arguments {
  FiniteOptions options;
  std::vector<Base> bases = {Base::fixed, Base::floating};
  Real real = Real::float64;
  std::vector<Files> robots;
};

/// Parses the arguments. Throws std::invalid_argument for an invalid one.
Arguments parse(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word.ends_with(".yaml") && !arguments.robots.empty()) {
      arguments.robots.back().scene = word;
      continue;
    }
    if (!word.starts_with("--")) {
      arguments.robots.push_back({word, ""});
      continue;
    }
    if (i + 1 == words.size()) throw std::invalid_argument(word + " needs a value");
    const std::string& value = words[++i];
    if (word == "--states") {
      arguments.options.states = std::stoll(value);
    } else if (word == "--first") {
      arguments.options.first = std::stoll(value);
    } else if (word == "--seed") {
      arguments.options.seed = std::stoull(value);
    } else if (word == "--length") {
      arguments.options.length = std::stod(value);
    } else if (word == "--flags") {
      arguments.options.flags = value;
    } else if (word == "--base") {
      arguments.bases = {value == "floating" ? Base::floating : Base::fixed};
    } else if (word == "--real") {
      arguments.real = value == "float" ? Real::float32 : Real::float64;
    } else {
      throw std::invalid_argument("there is no option " + word);
    }
  }
  if (arguments.robots.empty()) throw std::invalid_argument("no URDF is named");
  return arguments;
}

std::string first_error(const Diagnostics& diagnostics) {
  for (const Diagnostic& each : diagnostics.list()) {
    if (each.severity == Severity::error) return to_string(each);
  }
  return "no error is stated";
}

void print_found(const FiniteReport& report) {
  for (const NotFinite& each : report.found) {
    fmt::print("    {}: not finite at {} states, first {}: {}\n", each.function, each.times,
               each.first.index, print_inputs(each.first));
  }
}

bool search_one(const std::string& name, const Robot& robot, Scene scene,
                const Arguments& arguments, Diagnostics& diagnostics) {
  const auto start = std::chrono::steady_clock::now();
  fmt::print("{:<28} {:<8} ", name, scene.base == Base::floating ? "floating" : "fixed");
  if (arguments.real == Real::float32) scene.real = Real::float32;
  const auto report = search_not_finite(robot, scene, arguments.options, diagnostics);
  if (!report) {
    fmt::print("not made: {}\n", first_error(diagnostics));
    return false;
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  fmt::print("{:>2} functions, {} states, {} not finite, {} without a value, {:.0f} s\n",
             report->functions.size(), report->states, report->found.size(), report->without_value,
             taken.count());
  print_found(*report);
  std::fflush(stdout);
  return report->found.empty();
}

bool search(const Files& files, const Arguments& arguments) {
  const std::string name = std::filesystem::path(files.urdf).stem().string();
  Diagnostics diagnostics;
  const auto robot = read_urdf(files.urdf, diagnostics);
  std::vector<Scene> scenes;
  if (robot && !files.scene.empty()) {
    if (auto scene = read_scene(files.scene, *robot, diagnostics)) scenes.push_back(*scene);
  } else if (robot) {
    for (const Base base : arguments.bases) {
      if (auto scene = proposed_scene(*robot, base, diagnostics)) scenes.push_back(*scene);
    }
  }
  bool all = !diagnostics.has_errors();
  if (!all) fmt::print("{}: {}\n", name, first_error(diagnostics));
  for (const Scene& scene : scenes) {
    const std::string shown = files.scene.empty() ? name : scene.name;
    Diagnostics own;
    all = search_one(shown, *robot, scene, arguments, own) && all;
  }
  return all;
}

int run(const std::vector<std::string>& words) {
  const Arguments arguments = parse(words);
  bool all = true;
  for (const Files& files : arguments.robots) all = search(files, arguments) && all;
  return all ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "search_not_finite: {}\n", error.what());
    return 2;
  }
}
