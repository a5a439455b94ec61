#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>

#include "choice/function_mechanisms.hpp"
#include "compilation/run_commands.hpp"
#include "compilation/temporary_folder.hpp"
#include "emission/write_files.hpp"
#include "timing/describe_processor.hpp"
#include "timing/tune.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

/// Numbers of rounds: those that narrow the field of candidates, and those that compare the rest.
constexpr int kHeats = 11;
constexpr int kFinal = 61;
/// A candidate that is slower than the fastest by this factor has lost.
constexpr double kBehind = 1.04;
constexpr std::size_t kFinalists = 6;

std::optional<TimedBuild> build_one(const Robot& robot, const Scene& scene,
                                    const Mechanism& mechanism, const GeneratedFunction& candidate,
                                    const CompileOptions& compile, const fs::path& folder,
                                    Diagnostics& diagnostics) {
  fs::create_directories(folder);
  const auto files = emit_to_try(robot, scene, mechanism, candidate, diagnostics);
  if (files.empty() || !write_files(folder / "code", files, diagnostics)) return std::nullopt;
  return load_build(folder / "code", scene, {candidate}, compile, folder / "work", diagnostics);
}

/// Builds all candidates, with as many compilers at a time as there are cores.
std::optional<std::vector<TimedBuild>> build_all(const Robot& robot, const Scene& scene,
                                                 const Mechanism& mechanism,
                                                 const std::vector<GeneratedFunction>& candidates,
                                                 CompileOptions compile, const fs::path& folder,
                                                 Diagnostics& diagnostics) {
  compile.optimize = scene.optimize;
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int workers = compile.jobs > 0 ? compile.jobs : cores;
  compile.jobs = 1;
  std::vector<std::optional<TimedBuild>> builds(candidates.size());
  std::vector<Diagnostics> faults(candidates.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < candidates.size(); i = next++) {
      builds[i] = build_one(robot, scene, mechanism, candidates[i], compile,
                            folder / std::to_string(i), faults[i]);
    }
  };
  std::vector<std::future<void>> running;
  for (int i = 0; i < workers; ++i) running.push_back(std::async(std::launch::async, work));
  for (auto& worker : running) worker.get();
  std::vector<TimedBuild> made;
  for (std::size_t i = 0; i < builds.size(); ++i) {
    for (const Diagnostic& fault : faults[i].list()) diagnostics.add(fault);
    if (!builds[i]) return std::nullopt;
    made.push_back(std::move(*builds[i]));
  }
  return made;
}

/// Indices of the first candidate, and of the fastest others that may still win.
std::vector<std::size_t> find_finalists(const std::vector<Timing>& heats) {
  std::vector<std::size_t> order;
  for (std::size_t i = 1; i < heats.size(); ++i) order.push_back(i);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return heats[a].ratio < heats[b].ratio; });
  const double limit = order.empty() ? 0 : kBehind * std::min(1.0, heats[order.front()].ratio);
  std::erase_if(order, [&](std::size_t i) { return heats[i].ratio > limit; });
  if (order.size() > kFinalists) order.resize(kFinalists);
  order.insert(order.begin(), 0);
  return order;
}

std::vector<Timing> time_all(const std::vector<TimedCall>& calls) {
  TimingOptions options;
  options.rounds = kHeats;
  std::vector<Timing> timings = time_calls(calls, options);
  const std::vector<std::size_t> finalists = find_finalists(timings);
  std::vector<TimedCall> last;
  for (const std::size_t i : finalists) last.push_back(calls[i]);
  options.rounds = kFinal;
  const std::vector<Timing> final_timings = time_calls(last, options);
  // Ratios of the heats refer to another run of the first candidate; those of losers stay as they
  // are.
  for (std::size_t k = 0; k < finalists.size(); ++k) timings[finalists[k]] = final_timings[k];
  return timings;
}

}  // namespace

Measure measure_here(const Robot& robot, const Scene& scene, const CompileOptions& compile) {
  return [&robot, &scene, compile](const std::vector<GeneratedFunction>& candidates,
                                   Diagnostics& diagnostics) -> std::optional<std::vector<Timing>> {
    const auto folder = make_temporary_folder(diagnostics);
    if (!folder) return std::nullopt;
    FunctionMechanisms mechanisms(robot, scene);
    const Mechanism& mechanism = mechanisms.of(candidates.front().function);
    const auto builds =
        build_all(robot, scene, mechanism, candidates, compile, folder->path(), diagnostics);
    if (!builds) return std::nullopt;
    const auto states = draw_timing_states(robot, scene, mechanism, candidates);
    const CallArguments arguments(candidates.front(), states, scene.real);
    std::vector<TimedCall> calls;
    for (const TimedBuild& build : *builds) {
      calls.push_back({build.library.raw_entry(0), &arguments});
    }
    return time_all(calls);
  };
}

std::string describe_here(const CompileOptions& compile, Diagnostics& diagnostics) {
  const auto folder = make_temporary_folder(diagnostics);
  if (!folder) return "";
  const auto compiler = find_compiler(compile, folder->path(), diagnostics);
  if (!compiler) return "";
  Command asked = *compiler;
  asked.emplace_back("--version");
  const std::string version = run_commands({asked}, 1, folder->path()).front().output;
  return fmt::format("{}, {}, {}", version.substr(0, version.find('\n')), compile.flags,
                     describe_processor());
}

}  // namespace treeline
