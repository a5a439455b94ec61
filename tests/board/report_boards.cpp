// Tables of README.md here: every function of PUMA and humanoid24 on every board that QEMU
// imitates. With --small: the tables of small code in docs/evidence/small-code.md.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "board/check_on_board.hpp"
#include "description/follow_target.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"

namespace treeline {
namespace {

void print_faults(const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    fmt::print(stderr, "{}\n", to_string(diagnostic));
  }
}

/// Runs a robot's scene for one target. Nothing where a program is missing. `functions`: instead of
/// the scene's.
std::optional<BoardReport> run(const std::string& robots, const std::string& name,
                               const Target& target, Real real, Optimize optimize = Optimize::speed,
                               const std::vector<Function>& functions = {}) {
  Diagnostics diagnostics;
  const std::string folder = robots + "/" + name + "/";
  const auto robot = read_urdf(folder + name + ".urdf", diagnostics);
  auto scene = robot ? read_scene(folder + "scene.yaml", *robot, diagnostics) : std::nullopt;
  std::optional<BoardReport> report;
  if (scene) {
    scene->target = target.name;
    scene->real = real;
    scene->optimize = optimize;
    if (!functions.empty()) scene->functions = functions;
    scene->asks_for_lanes = false;
    follow_target(*scene);
    const auto generation = generate_code(*robot, *scene, {name, "", "", ""}, diagnostics);
    CheckOptions options;
    options.references.states = name == "puma560" ? 300 : 100;
    options.compile.long_flags = "-O1 -ffp-contract=off";
    if (!functions.empty()) options.references.states = 10;
    if (generation) report = check_on_board(*robot, *scene, *generation, options, {}, diagnostics);
  }
  print_faults(diagnostics);
  return report;
}

std::string print_count(const BoardFunction& f) {
  return f.takes_constant_time() ? std::to_string(f.most) : fmt::format("{}..{}", f.least, f.most);
}

void print_tables(const std::string& name, Real real, const std::vector<BoardReport>& reports) {
  std::string heads, lines;
  for (const BoardReport& report : reports) {
    heads += fmt::format(" {} |", report.target->name);
    lines += "---|";
  }
  const auto print_table = [&](const char* title, auto print) {
    fmt::print("\n{}, {}: {}\n\n| function |{}\n|---|{}\n", name,
               real == Real::float32 ? "float" : "double", title, heads, lines);
    for (std::size_t i = 0; i < reports.front().functions.size(); ++i) {
      fmt::print("| `{}` |", reports.front().functions[i].name);
      for (const BoardReport& report : reports) fmt::print(" {} |", print(report.functions[i]));
      fmt::print("\n");
    }
  };
  print_table("instructions of a call, least and most where they differ", print_count);
  print_table("cycles of the longest call, estimated",
              [](const BoardFunction& f) { return fmt::format("{:.0f}", f.cycles); });
  print_table("bytes of text and constants",
              [](const BoardFunction& f) { return f.text_bytes + f.constant_bytes; });
  print_table("bytes of stack, by the compiler / seen", [](const BoardFunction& f) {
    return fmt::format("{} / {}", f.stack_bytes.value_or(-1), f.stack_seen);
  });
}

/// Runs one robot in one format on the boards that have instructions for it.
bool report_robot(const std::string& robots, const std::string& name, Real real) {
  std::vector<BoardReport> reports;
  bool passed = true;
  for (const Target& target : all_targets()) {
    const bool large = name != "puma560" && emulates(target, bytes_of(real));
    if (target.board.kind == BoardKind::none || large) continue;
    auto report = run(robots, name, target, real);
    if (!report) return false;
    passed = passed && report->passed();
    fmt::print(stderr, "{} {} {}: {} s to compile, {} s to run, {}\n", name, target.name,
               bytes_of(real), report->compile_seconds, report->run_seconds,
               report->passed() ? "passed" : print_text(*report));
    reports.push_back(std::move(*report));
  }
  print_tables(name, real, reports);
  return passed;
}

/// What `optimize: size` gives in place of `speed`: bytes of code and constants, stack,
/// instructions.
bool report_small_code(const std::string& robots, const std::string& name, Real real) {
  const std::vector<Function> functions = {
      Function::inverse_dynamics, Function::gravity,          Function::nonlinear_effects,
      Function::mass_matrix,      Function::forward_dynamics, Function::lambda_inverse,
      Function::lambda,           Function::control_torque};
  const Target& target = *find_target("cortex-m4f");
  const auto lines = run(robots, name, target, real, Optimize::speed, functions);
  const auto small = run(robots, name, target, real, Optimize::size, functions);
  if (!lines || !small) return false;
  fmt::print(
      "\n| {}, {} | bytes: `speed` | `size` | share | stack: `speed` | `size` | "
      "instructions: `speed` | `size` |\n"
      "|---|---|---|---|---|---|---|---|\n",
      name, real == Real::float32 ? "float" : "double");
  for (std::size_t i = 0; i < lines->functions.size(); ++i) {
    const BoardFunction& a = lines->functions[i];
    const BoardFunction& b = small->functions[i];
    const int before = a.text_bytes + a.constant_bytes;
    const int after = b.text_bytes + b.constant_bytes;
    fmt::print("| `{}` | {} | {} | {:.0f} % | {} | {} | {} | {} |\n", a.name, before, after,
               100.0 * after / before, a.stack_bytes.value_or(-1), b.stack_bytes.value_or(-1),
               print_count(a), print_count(b));
  }
  std::fflush(stdout);
  return lines->passed() && small->passed();
}

}  // namespace
}  // namespace treeline

int main(int argc, char** argv) try {
  if (argc < 2) return 2;
  bool passed = true;
  if (argc > 2 && std::string_view(argv[2]) == "--small") {
    for (const treeline::Real real : {treeline::Real::float32, treeline::Real::float64}) {
      passed = treeline::report_small_code(argv[1], "humanoid24", real) && passed;
    }
    return passed ? 0 : 1;
  }
  for (const char* name : {"puma560", "humanoid24"}) {
    if (argc > 2 && std::string_view(argv[2]) != name) continue;
    for (const treeline::Real real : {treeline::Real::float32, treeline::Real::float64}) {
      passed = treeline::report_robot(argv[1], name, real) && passed;
    }
  }
  return passed ? 0 : 1;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 1;
}
