#include "compatibility/measure_row.hpp"

#include <fmt/format.h>

#include <ctime>

#include "check/digits.hpp"
#include "description/read_urdf.hpp"
#include "generation/generate_code.hpp"

namespace treeline::tests {
namespace {

std::string first_error(const Diagnostics& diagnostics) {
  for (const Diagnostic& d : diagnostics.list()) {
    if (d.severity == Severity::error) return d.fault;
  }
  return "no error is stated";
}

void generate(const Robot& robot, const Scene& scene, CompatibilityRow& row) {
  Diagnostics diagnostics;
  const std::clock_t start = std::clock();
  const auto generation =
      generate_code(robot, scene, {"robot.urdf", "", "scene.yaml", ""}, diagnostics);
  row.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (!generation) {
    row.failure = first_error(diagnostics);
    return;
  }
  row.freedoms = generation->mechanism.nv();
  for (const GeneratedFunction& generated : generation->functions) {
    row.operations[function_name(generated.function)] = generated.chosen.count.flops();
  }
}

}  // namespace

std::string CompatibilityCase::robot_name() const {
  return robot.name.substr(robot.name.find('/') + 1);
}

std::string CompatibilityCase::base_name() const {
  return base == Base::floating ? "floating" : "fixed";
}

std::vector<CompatibilityCase> compatibility_cases() {
  std::vector<CompatibilityCase> cases;
  for (const DataRobot& robot : data_robots("published")) {
    cases.push_back({robot, Base::fixed});
    cases.push_back({robot, Base::floating});
  }
  return cases;
}

CompatibilityRow measure_row(const CompatibilityCase& of, bool with_digits) {
  CompatibilityRow row;
  row.of = of;
  Diagnostics diagnostics;
  const auto robot = read_urdf(of.robot.path, diagnostics);
  if (!robot) {
    row.failure = first_error(diagnostics);
    return row;
  }
  const auto scene = make_scene(*robot, of.base);
  if (!scene) {
    row.failure = "nothing moves";
    return row;
  }
  row.asked = static_cast<int>(scene->functions.size());
  generate(*robot, *scene, row);
  if (!with_digits || !row.failure.empty()) return row;
  for (const DigitsLeft& left : measure_digits(of.robot_name(), *robot, *scene)) {
    row.digits[left.function] = left.digits ? fmt::format("{:.1f}", *left.digits) : "-";
  }
  return row;
}

}  // namespace treeline::tests
