#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "bench/cold_report.hpp"
#include "compilation/temporary_folder.hpp"
#include "description/scene_words.hpp"
#include "emission/write_files.hpp"
#include "generation/without_callers.hpp"
#include "timing/load_build.hpp"

namespace treeline {
namespace {

constexpr std::array kChoices = {Optimize::speed, Optimize::size};

/// The scene's functions of one state, without what calls them.
Scene scene_for(Scene scene, Optimize optimize) {
  scene.optimize = optimize;
  scene.batch = 0;
  return without_callers(std::move(scene));
}

/// All functions by one value of `optimize`, compiled and loaded.
struct ColdBuild {
  Generation generation;
  TimedBuild build;
};

std::optional<ColdBuild> make_build(const Robot& robot, const Scene& scene,
                                    const std::string& flags, const std::filesystem::path& work,
                                    Diagnostics& diagnostics) {
  auto generation = generate_code(robot, scene, {}, diagnostics);
  if (!generation) return std::nullopt;
  const std::filesystem::path sources = work / "sources";
  if (!write_files(sources, generation->files, diagnostics)) return std::nullopt;
  CompileOptions options{flags};
  options.optimize = scene.optimize;
  auto build =
      load_build(sources, scene, generation->functions, options, work / "objects", diagnostics);
  if (!build) return std::nullopt;
  return ColdBuild{std::move(*generation), std::move(*build)};
}

ColdRow describe_build(const ColdBuild& made, std::size_t i, Optimize optimize) {
  const GeneratedFunction& generated = made.generation.functions[i];
  const CompiledFunction& compiled = made.build.compilation.functions.at(source_stem(generated));
  ColdRow row;
  row.optimize = {optimize};
  row.method = describe(generated.chosen.route);
  row.is_small = compiled.is_small;
  const auto constants = measure_constants(made.build.compilation, source_stem(generated));
  if (compiled.code_bytes && constants) row.bytes = *compiled.code_bytes + *constants;
  return row;
}

/// Function `i` of every build, those with the same code once.
ColdFunction measure_cold_function(const std::vector<ColdBuild>& builds, std::size_t i,
                                   const std::vector<State>& states, Real real,
                                   const ColdBenchOptions& options) {
  ColdFunction made{builds.front().generation.functions[i].function, {}};
  const CallArguments arguments(builds.front().generation.functions[i], states, real);
  std::vector<TimedCall> warm;
  std::vector<ColdCall> cold;
  for (std::size_t k = 0; k < builds.size(); ++k) {
    ColdRow row = describe_build(builds[k], i, kChoices[k]);
    const auto same = std::find_if(made.rows.begin(), made.rows.end(), [&](const ColdRow& other) {
      return other.method == row.method && other.is_small == row.is_small;
    });
    if (same != made.rows.end()) {
      same->optimize.push_back(kChoices[k]);
      continue;
    }
    const GeneratedLibrary& library = builds[k].build.library;
    warm.push_back({library.raw_entry(i), &arguments});
    cold.push_back({warm.back(), builds[k].build.compilation.library.string()});
    made.rows.push_back(std::move(row));
  }
  const std::vector<Timing> warm_times = time_calls(warm, options.warm);
  const std::vector<ColdTiming> cold_times = time_cold_calls(cold, options.rounds);
  for (std::size_t k = 0; k < made.rows.size(); ++k) {
    made.rows[k].warm = warm_times[k];
    made.rows[k].cold = cold_times[k];
  }
  return made;
}

}  // namespace

std::string names_of(const ColdRow& row) {
  std::vector<std::string> names;
  for (const Optimize each : row.optimize) names.push_back(word_of(each));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::optional<ColdReport> run_cold_bench(const Robot& robot, const Scene& scene,
                                         const ColdBenchOptions& options,
                                         Diagnostics& diagnostics) {
  const auto tell = [&](const char* what, std::size_t done, std::size_t total) {
    if (options.progress) options.progress(what, static_cast<int>(done), static_cast<int>(total));
  };
  const auto work = make_temporary_folder(diagnostics);
  if (!work) return std::nullopt;
  std::vector<ColdBuild> builds;
  for (std::size_t k = 0; k < kChoices.size(); ++k) {
    tell("compiling", k, kChoices.size());
    Diagnostics found;
    auto made = make_build(robot, scene_for(scene, kChoices[k]), options.flags,
                           work->path() / word_of(kChoices[k]), found);
    for (const Diagnostic& each : found.list()) {  // notes of the first build hold for all
      if (k == 0 || each.severity == Severity::error) diagnostics.add(each);
    }
    if (!made) return std::nullopt;
    builds.push_back(std::move(*made));
  }
  tell("compiling", kChoices.size(), kChoices.size());
  const std::vector<GeneratedFunction>& functions = builds.front().generation.functions;
  const std::vector<State> states = draw_timing_states(
      robot, scene, builds.front().generation.mechanism, functions, 64, options.seed);
  ColdReport report{scene.name,
                    robot.name,
                    describe_machine(builds.front().build.compilation.command),
                    options.flags,
                    {}};
  for (std::size_t i = 0; i < functions.size(); ++i) {
    tell("measuring", i, functions.size());
    report.functions.push_back(measure_cold_function(builds, i, states, scene.real, options));
  }
  tell("measuring", functions.size(), functions.size());
  return report;
}

}  // namespace treeline
