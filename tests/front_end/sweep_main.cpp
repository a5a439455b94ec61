// Generates every published robot on a fixed and on a floating base in scenes of every kind, and
// lets a compiler's front end read the code: sweep_scenes [K/N]. Of N shares, in the order of a
// hash, it takes share K, counted from 0. A line for each; a robot that is refused with errors that
// say what to do is none that fails. Exit status: 0 nothing failed, 1 something did, 2 usage.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compilation/run_commands.hpp"
#include "compilation/temporary_folder.hpp"
#include "data/list_data.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "emission/write_files.hpp"
#include "front_end/scene_kinds.hpp"
#include "generation/generate_code.hpp"
#include "program/hash_word.hpp"

namespace {

using namespace treeline;         // NOLINT: a program, not a header
using namespace treeline::tests;  // NOLINT

struct Combination {
  DataRobot robot;
  Base base = Base::fixed;
  const SceneKind* kind = nullptr;

  [[nodiscard]] std::string name() const {
    return fmt::format("{} {} {}", robot.name, base == Base::fixed ? "fixed" : "floating",
                       kind->name);
  }
};

std::uint64_t hash_of(const std::string& name) {
  std::uint64_t hash = 0;
  for (const char c : name) hash = hash_word(hash, static_cast<unsigned char>(c));
  return hash;
}

/// All, in the order of their hashes.
std::vector<Combination> list_combinations() {
  std::vector<Combination> all;
  for (const DataRobot& robot : data_robots("published")) {
    for (const Base base : {Base::fixed, Base::floating}) {
      for (const SceneKind& kind : scene_kinds()) all.push_back({robot, base, &kind});
    }
  }
  std::sort(all.begin(), all.end(), [](const Combination& a, const Combination& b) {
    return hash_of(a.name()) < hash_of(b.name());
  });
  return all;
}

enum class Verdict { well_formed, refused, without, failed };

struct Outcome {
  Verdict verdict = Verdict::failed;
  std::string detail;
};

/// Errors that say what to do are a refusal.
Outcome judge(const Diagnostics& diagnostics) {
  Outcome outcome{Verdict::refused, {}};
  for (const Diagnostic& each : diagnostics.list()) {
    if (each.severity != Severity::error) continue;
    if (each.remedy.empty()) outcome.verdict = Verdict::failed;
    outcome.detail += (outcome.detail.empty() ? "" : "; ") + fault_of(each);
  }
  if (outcome.detail.empty()) return {Verdict::failed, "nothing, and no error"};
  return outcome;
}

/// Lets a front end read the sources, with the warnings that generated code promises not to cause.
Outcome read_sources(const std::vector<GeneratedFile>& files, const std::filesystem::path& folder) {
  Diagnostics diagnostics;
  if (!write_files(folder, files, diagnostics)) {
    return {Verdict::failed, judge(diagnostics).detail};
  }
  std::vector<Command> commands;
  std::size_t bytes = 0;
  for (const GeneratedFile& file : files) {
    bytes += file.text.size();
    const bool is_c = file.name.ends_with(".c");
    if (!is_c && !file.name.ends_with(".cpp")) continue;
    commands.push_back({is_c ? "gcc" : "g++", is_c ? "-std=c99" : "-std=c++17", "-fsyntax-only",
                        "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror",
                        folder / file.name});
  }
  for (const CommandOutcome& outcome : run_commands(commands, count_cores(0), folder)) {
    if (outcome.exit_code != 0) return {Verdict::failed, first_lines(outcome.output)};
  }
  return {Verdict::well_formed,
          fmt::format("{} sources, {:.1f} MB", commands.size(), static_cast<double>(bytes) / 1e6)};
}

Outcome try_combination(const Combination& of) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(of.robot.path, diagnostics);
  if (!robot) return judge(diagnostics);
  const std::string kind = of.kind->print(propose_scene(*robot, of.base));
  if (kind.empty()) return {Verdict::without, "too few points"};
  const std::string text =
      fmt::format("name: swept\nbase: {}\n{}", of.base == Base::fixed ? "fixed" : "floating", kind);
  const auto scene = parse_scene(text, "scene.yaml", *robot, diagnostics);
  if (!scene) return judge(diagnostics);
  const auto generation =
      generate_code(*robot, *scene, {"robot.urdf", "", "scene.yaml", text}, diagnostics);
  if (!generation) return judge(diagnostics);
  const TemporaryFolder folder;
  return read_sources(generation->files, folder.path() / "code");
}

Outcome try_to_end(const Combination& of) {
  try {
    return try_combination(of);
  } catch (const std::exception& fault) {
    return {Verdict::failed, fault.what()};
  }
}

struct Share {
  std::size_t own = 0, of = 1;
};

std::optional<Share> read_share(const char* text) {
  unsigned own = 0, of = 0;
  char more = 0;
  if (std::sscanf(text, "%u/%u%c", &own, &of, &more) != 2 || own >= of) return std::nullopt;
  return Share{own, of};
}

int sweep(const Share& share) {
  constexpr const char* kVerdicts[] = {"well-formed", "refused", "without", "FAILED"};
  using Clock = std::chrono::steady_clock;
  const std::vector<Combination> all = list_combinations();
  int counts[4] = {};
  std::string failures;
  for (std::size_t i = share.own; i < all.size(); i += share.of) {
    const auto start = Clock::now();
    const Outcome outcome = try_to_end(all[i]);
    ++counts[static_cast<std::size_t>(outcome.verdict)];
    const std::string line =
        fmt::format("{:<44} {:<11} {:6.1f} s  {}\n", all[i].name(),
                    kVerdicts[static_cast<std::size_t>(outcome.verdict)],
                    std::chrono::duration<double>(Clock::now() - start).count(), outcome.detail);
    fmt::print("{}", line);
    std::fflush(stdout);
    if (outcome.verdict == Verdict::failed) failures += line;
  }
  fmt::print(
      "{}share {}/{} of {} combinations: {} well-formed, {} refused in words, {} without "
      "such a scene, {} failed\n",
      failures, share.own, share.of, all.size(), counts[0], counts[1], counts[2], counts[3]);
  return counts[3] == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const auto share = argc == 1 ? std::optional(Share{}) : read_share(argv[1]);
  if (argc > 2 || !share) {
    fmt::print(stderr, "usage: sweep_scenes [K/N], with K below N\n");
    return 2;
  }
  try {
    return sweep(*share);
  } catch (const std::exception& error) {
    fmt::print(stderr, "sweep_scenes: {}\n", error.what());
    return 1;
  }
}
