#include "check/digits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "choice/evaluate_damped.hpp"
#include "data/list_data.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/leave_out_singular.hpp"
#include "oracle/reference.hpp"
#include "passes/choose.hpp"
#include "passes/passes.hpp"
#include "recursion/routes/trace_function.hpp"

namespace treeline::tests {
namespace {

namespace fs = std::filesystem;

constexpr int kStates = 40;  ///< of every class but at rest, see `class_of_state`

std::vector<fs::path> sorted_files(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> end_links(const Robot& robot) {
  std::set<int> parents;
  for (const Joint& joint : robot.joints) {
    // A link behind a fixed joint is not an end of its own.
    if (joint.type != JointType::fixed) parents.insert(joint.parent);
  }
  std::vector<std::string> ends;
  for (const Joint& joint : robot.joints) {
    if (joint.type != JointType::fixed && !parents.contains(joint.child)) {
      ends.push_back(robot.links[static_cast<std::size_t>(joint.child)].name);
    }
  }
  return ends;
}

std::string scene_text(Base base, const std::vector<std::string>& ends, std::size_t points,
                       const std::string& rows) {
  std::string text = "name: made\nlanes: 1\nsingular: exact\n";
  text += base == Base::floating ? "base: floating\n" : "base: fixed\n";
  if (points > 0) text += "operational_points:\n";
  for (std::size_t i = 0; i < points; ++i) {
    text += fmt::format("  - {{name: end_{}, link: \"{}\", rows: [{}]}}\n", i,
                        ends[ends.size() - 1 - i], rows);
  }
  return text;
}

/// The cheapest route as traced.
GeneratedFunction cheapest(const Mechanism& mechanism, Function function) {
  GeneratedFunction generated;
  generated.function = function;
  double least = 0;
  for (const Program& route : trace_function(mechanism, function)) {
    Program canonical = canonicalize(route);
    const double weighted = cost(canonical, count_operations(canonical));
    if (!generated.program.results.empty() && !(weighted < least)) continue;
    least = weighted;
    generated.program = std::move(canonical);
  }
  return generated;
}

DigitsLeft worst_digits(const std::string& subject, std::size_t i, Function function, Real real,
                        const std::vector<StateReference>& references) {
  DigitsLeft row{subject, function_name(function), {}};
  for (const StateReference& reference : references) {
    const FunctionReference& at = reference.functions[i];
    if (at.singular || at.high.empty()) continue;
    const double ulp = std::max(error_in_ulp(at.graph, at, unit_of(real)), 0.25);
    const double digits = std::max(0.0, -std::log10(ulp * unit_of(real)));
    row.digits = std::min(row.digits.value_or(digits), digits);
  }
  return row;
}

}  // namespace

std::vector<DigitsSubject> list_subjects(const std::string& robots) {
  std::vector<DigitsSubject> subjects;
  for (const fs::path& urdf : sorted_files(robots, ".urdf")) {
    for (const fs::path& scene : sorted_files(urdf.parent_path(), ".yaml")) {
      // Scenes in folders beside the robot are those of experiments.
      if (scene.parent_path() != urdf.parent_path()) continue;
      if (!scene.stem().string().starts_with("scene")) continue;
      subjects.push_back({urdf.stem().string() + "/" + scene.stem().string(), urdf, scene});
    }
  }
  for (const char* folder : {"golden", "published"}) {
    for (const DataRobot& robot : data_robots(folder)) {
      subjects.push_back({robot.name, robot.path, ""});
    }
  }
  return subjects;
}

std::optional<Scene> make_scene(const Robot& robot, std::optional<Base> base) {
  const std::vector<std::string> ends = end_links(robot);
  const bool floats = ends.empty() || ends.size() >= 4;
  const Base chosen = base.value_or(floats ? Base::floating : Base::fixed);
  for (std::size_t points = std::min<std::size_t>(2, ends.size()) + 1; points-- > 0;) {
    for (const char* rows : {"x, y, z, rx, ry, rz", "x, y, z", "x"}) {
      Diagnostics diagnostics;
      if (auto scene =
              parse_scene(scene_text(chosen, ends, points, rows), "made", robot, diagnostics)) {
        // Rows that a plain solve can handle, solved as they are by default.
        scene->singular = SingularTasks::smooth;
        leave_out_singular(robot, *scene, "", diagnostics);
        return scene;
      }
    }
  }
  return std::nullopt;
}

std::vector<DigitsLeft> measure_digits(const DigitsSubject& subject) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(subject.urdf, diagnostics);
  if (!robot) throw std::runtime_error("cannot read " + subject.urdf);
  const auto scene =
      subject.scene.empty() ? make_scene(*robot) : read_scene(subject.scene, *robot, diagnostics);
  if (!scene) throw std::runtime_error("no scene for " + subject.name);
  return measure_digits(subject.name, *robot, *scene);
}

std::vector<DigitsLeft> measure_digits(const std::string& subject, const Robot& robot,
                                       const Scene& scene) {
  Generation generation;
  generation.mechanism = reduced_mechanism(robot, scene);
  for (const Function function : scene.functions) {
    generation.functions.push_back(cheapest(generation.mechanism, function));
  }
  if (scene.damped) generation.damped = compose_damped(generation.functions);
  ReferenceOptions options;
  options.states = kStates;
  options.first = 1;
  options.threads = 1;
  const auto references = make_references(robot, scene, generation, options);
  std::vector<DigitsLeft> rows;
  const auto functions = all_callable(generation);
  for (std::size_t i = 0; i < functions.size(); ++i) {
    rows.push_back(worst_digits(subject, i, functions[i].function, scene.real, references));
  }
  return rows;
}

std::string print_digits(const std::vector<DigitsLeft>& rows) {
  std::string text = "subject,function,digits\n";
  for (const DigitsLeft& row : rows) {
    text += fmt::format("{},{},{}\n", row.subject, row.function,
                        row.digits ? fmt::format("{:.1f}", *row.digits) : "-");
  }
  return text;
}

std::vector<DigitsLeft> read_digits(const std::string& path) {
  std::vector<DigitsLeft> rows;
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    DigitsLeft row;
    std::string digits;
    std::getline(fields, row.subject, ',');
    std::getline(fields, row.function, ',');
    std::getline(fields, digits, ',');
    if (digits != "-") row.digits = std::stod(digits);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace treeline::tests
