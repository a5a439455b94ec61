#include "reproducibility/reproduce.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "check/judges.hpp"
#include "compilation/compile_folder.hpp"
#include "compilation/run_commands.hpp"
#include "compilation/temporary_folder.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "emission/write_files.hpp"

namespace treeline::tests {
namespace {

[[noreturn]] void fail(const Diagnostics& diagnostics, const std::string& what) {
  std::string text = what;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    if (diagnostic.severity == Severity::error) text.append("\n").append(to_string(diagnostic));
  }
  throw std::runtime_error(text);
}

/// Whether all bits are equal, including the sign of zero. All NaNs count as equal.
bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  const auto same = [](double x, double y) {
    return (x != x && y != y) || std::memcmp(&x, &y, sizeof x) == 0;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

/// Compares function `i` at one state with `expected`. The sizes of its terms are those of the
/// reference.
void note(const std::vector<double>& actual, const std::vector<double>& expected,
          const FunctionReference& reference, const Bound& bound, double unit, Difference& row) {
  ++row.states;
  row.bits_differ += same_bits(actual, expected) ? 0 : 1;
  if (reference.singular) return;
  FunctionReference other;
  other.high = expected;
  other.low.assign(expected.size(), 0);
  other.size = reference.size;
  const double difference = error_in_ulp(actual, other, unit);
  row.worst = std::max(row.worst, difference);
  row.share = std::max(row.share, difference / bound.at(reference));
}

Difference begin_row(const Original& original, const GeneratedFunction& function,
                     const Build& build) {
  Difference row;
  row.robot = original.name;
  row.function = source_stem(function);
  row.build = build;
  row.solves = solve_of(function.function) != Solve::none;
  return row;
}

bool runs(const std::vector<Command>& commands, std::string* output = nullptr) {
  const TemporaryFolder work;
  for (const CommandOutcome& outcome : run_commands(commands, 1, work.path())) {
    if (!outcome.started || outcome.exit_code != 0) return false;
    if (output != nullptr) *output += outcome.output;
  }
  return true;
}

}  // namespace

Original load_original(const std::string& robots, const std::string& name, int states,
                       const std::vector<Function>& functions, Real real, int lanes, int batch) {
  const std::string folder = robots + "/" + name + "/";
  Diagnostics diagnostics;
  const auto robot = read_urdf(folder + name + ".urdf", diagnostics);
  if (!robot) fail(diagnostics, name);
  auto scene = read_scene(folder + "scene.yaml", *robot, diagnostics, functions);
  if (!scene) fail(diagnostics, name);
  scene->real = real;
  scene->singular = SingularTasks::exact;  // borders of rows differ between float and double
  scene->lanes = lanes;
  scene->batch = batch;
  auto generation = generate_code(*robot, *scene, {"r.urdf", "", "s.yaml", ""}, diagnostics);
  if (!generation) fail(diagnostics, name);
  ReferenceOptions options;
  options.states = states;
  auto references = make_references(*robot, *scene, *generation, options);
  return {name, *robot, *scene, std::move(*generation), std::move(references)};
}

bool has_compiler(const std::string& compiler) {
  return runs({{compiler, "--version"}});
}

std::string separate_for_machine(const std::string& compiler) {
  const std::string flags = "-march=native -ffp-contract=off";
  std::string macros;
  const bool fuses =
      runs({{compiler, "-march=native", "-dM", "-E", "-x", "c++", "/dev/null"}}, &macros) &&
      macros.find("__FMA__") != std::string::npos;
  const bool is_gcc = macros.find("__clang__") == std::string::npos;
  return fuses && is_gcc ? flags + " -fno-tree-slp-vectorize" : flags;
}

GeneratedLibrary build_library(const Original& original, const Build& build) {
  const TemporaryFolder work;
  const auto sources = work.path() / original.scene.name;
  const auto objects = work.path() / "objects";
  std::filesystem::create_directory(objects);
  Diagnostics diagnostics;
  CompileOptions options;
  options.compiler = build.compiler;
  options.flags = build.flags;
  options.language = original.scene.language;
  options.more = limited_sources(original.scene, original.generation);
  const auto functions = all_callable(original.generation);
  if (write_files(sources, original.generation.files, diagnostics)) {
    const auto made =
        compile_folder(sources, original.scene.name, functions, options, objects, diagnostics);
    if (made) {
      auto library =
          GeneratedLibrary::load(made->library, functions, original.scene.real, diagnostics);
      if (library) return std::move(*library);
    }
  }
  fail(diagnostics, original.name);
}

std::vector<Difference> compare_with_graph(const Original& original, const Build& build,
                                           const Original* other) {
  const GeneratedLibrary library = build_library(other != nullptr ? *other : original, build);
  const auto functions = all_callable(original.generation);
  const double unit = unit_of(original.scene.real);
  std::vector<Difference> rows;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const Bound bound = find_bound(i, functions[i].function, original.references);
    rows.push_back(begin_row(original, functions[i], build));
    for (const StateReference& at : original.references) {
      note(library.call(i, at.state).entries, at.functions[i].graph, at.functions[i], bound, unit,
           rows.back());
    }
  }
  return rows;
}

std::vector<Difference> compare_with_double(const Original& in_float, const Original& in_double,
                                            const Build& build) {
  const GeneratedLibrary single = build_library(in_float, build);
  const GeneratedLibrary twice = build_library(in_double, build);
  const auto functions = all_callable(in_float.generation);
  std::vector<Difference> rows;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const Bound bound = find_bound(i, functions[i].function, in_float.references);
    rows.push_back(begin_row(in_float, functions[i], build));
    rows.back().build.flags += " (float against double)";
    for (const StateReference& at : in_float.references) {
      note(single.call(i, at.state).entries, twice.call(i, at.state).entries, at.functions[i],
           bound, unit_of(Real::float32), rows.back());
    }
  }
  return rows;
}

std::string print_csv(const std::vector<Difference>& rows) {
  std::string text = "robot,function,compiler,flags,states,bits_differ,worst_ulp,share_of_bound\n";
  for (const Difference& row : rows) {
    text += fmt::format("{},{},{},{},{},{},{:.3g},{:.3g}\n", row.robot, row.function,
                        row.build.compiler, row.build.flags, row.states, row.bits_differ, row.worst,
                        row.share);
  }
  return text;
}

std::string print_table(const std::vector<Difference>& rows) {
  constexpr const char* kLine = "{:<10} {:<7} {:<68} {:>9} {:>7} {:>6} {:>10} {:>8}\n";
  struct Sum {
    Build build;
    std::string robot;
    int functions = 0, results = 0, differ = 0;
    double worst = 0, share = 0;
  };
  std::vector<Sum> sums;
  for (const Difference& row : rows) {
    if (sums.empty() || sums.back().robot != row.robot ||
        sums.back().build.compiler != row.build.compiler ||
        sums.back().build.flags != row.build.flags) {
      sums.push_back({row.build, row.robot});
    }
    Sum& sum = sums.back();
    ++sum.functions;
    sum.results += row.states;
    sum.differ += row.bits_differ;
    if (!row.solves) sum.worst = std::max(sum.worst, row.worst);
    sum.share = std::max(sum.share, row.share);
  }
  std::string text = fmt::format(kLine, "robot", "", "flags", "functions", "results", "differ",
                                 "worst ulp", "of bound");
  for (const Sum& sum : sums) {
    text += fmt::format(kLine, sum.robot, sum.build.compiler, sum.build.flags, sum.functions,
                        sum.results, sum.differ, fmt::format("{:.3g}", sum.worst),
                        fmt::format("{:.2g}", sum.share));
  }
  return text;
}

}  // namespace treeline::tests
