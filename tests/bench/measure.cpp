#include "measure.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <span>

#include "packs.hpp"
#include "timing/evict_caches.hpp"

namespace treeline::bench {
namespace {

constexpr int kStates = 64;
constexpr int kColdCalls = 16;  ///< in a repetition
/// This program and the libraries that a solver can call. Others of DART (meshes, images) are many
/// times larger than all of these.
const std::vector<std::string> kObjects = {"",        "libdart.so", "orocos-kdl",
                                           "libm.so", "libc.so",    "libstdc++"};

/// Inputs of one function in 64 states, grouped by the states that a call takes, and memory for its
/// output.
struct Inputs {
  std::vector<std::vector<Aligned>> packs;
  std::vector<std::vector<const double*>> pointers;
  Aligned output;
  double states;  ///< a call

  Inputs(const Case& robot, Function function, const Routine& routine)
      : output(static_cast<std::size_t>(output_size(function, robot) * routine.states)),
        states(routine.states) {
    const auto all = random_states(robot, kStates, 1);
    const auto width = static_cast<std::size_t>(routine.states);
    for (std::size_t i = 0; i < kStates; i += width) {
      packs.push_back(pack_inputs(function, {all.data() + i, width}));
      auto& in = pointers.emplace_back();
      for (const Aligned& input : packs.back()) in.push_back(input.data());
    }
  }
};

void warm(benchmark::State& run, const Routine& routine, Inputs inputs) {
  while (run.KeepRunningBatch(kStates)) {
    for (const auto& in : inputs.pointers) {
      routine(in.data(), inputs.output.data());
      benchmark::ClobberMemory();
    }
  }
}

void dependent(benchmark::State& run, const Routine& routine, Inputs inputs) {
  const std::size_t size = inputs.packs[0][0].size();
  const std::size_t last = inputs.output.size() - 1;
  Aligned q(size);
  while (run.KeepRunningBatch(kStates)) {
    for (std::size_t i = 0; i < inputs.packs.size(); ++i) {
      // Too small to change a digit, but the processor cannot know that.
      const double nothing = 1e-300 * (inputs.output[0] + inputs.output[last]);
      const double* from = inputs.packs[i][0].data();
      for (std::size_t k = 0; k < size; ++k) q[k] = from[k] + nothing;
      std::vector<const double*>& in = inputs.pointers[i];
      in[0] = q.data();
      routine(in.data(), inputs.output.data());
      benchmark::ClobberMemory();
    }
  }
}

double seconds_of_one_call(const Routine& routine, const double* const* in, double* out) {
  using Clock = std::chrono::steady_clock;
  benchmark::DoNotOptimize(Clock::now());  // brings the clock's own code back
  const auto start = Clock::now();
  routine(in, out);
  benchmark::ClobberMemory();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::span<const std::byte> bytes_of(const Aligned& numbers) {
  return std::as_bytes(std::span(numbers.data(), numbers.size()));
}

void evicted(benchmark::State& run, const Routine& routine, Inputs inputs, Mode mode) {
  std::size_t i = 0;
  for (auto _ : run) {
    const std::size_t k = i++ % inputs.packs.size();
    std::vector<std::span<const std::byte>> data{bytes_of(inputs.output)};
    for (const Aligned& input : inputs.packs[k]) data.push_back(bytes_of(input));
    if (mode == Mode::cold) {
      evict_from_core();
    } else if (!evict_from_caches(data, kObjects)) {
      run.SkipWithError("no instruction to flush a cache line");
      break;
    }
    const double* const* in = inputs.pointers[k].data();
    run.SetIterationTime(seconds_of_one_call(routine, in, inputs.output.data()) / inputs.states);
  }
}

void register_mode(const std::string& name, const Case& robot, Function function,
                   const Routine& routine, Mode mode) {
  const bool cold = mode == Mode::cold || mode == Mode::flushed;
  const auto body = [&robot, &routine, function, mode, cold](benchmark::State& run) {
    Inputs inputs(robot, function, routine);
    if (cold) {
      evicted(run, routine, std::move(inputs), mode);
    } else if (mode == Mode::warm) {
      warm(run, routine, std::move(inputs));
    } else {
      dependent(run, routine, std::move(inputs));
    }
  };
  auto* registered = benchmark::RegisterBenchmark((name + '/' + name_of(mode)).c_str(), body);
  registered->Unit(benchmark::kNanosecond);
  if (cold) registered->UseManualTime()->Iterations(kColdCalls);
}

}  // namespace

std::string name_of(Mode mode) {
  switch (mode) {
    case Mode::warm:
      return "warm";
    case Mode::dependent:
      return "dependent";
    case Mode::cold:
      return "cold";
    case Mode::flushed:
      break;
  }
  return "flushed";
}

void register_benchmarks(const Case& robot, const std::vector<Subject>& subjects) {
  for (const Function function : kFunctions) {
    for (const Subject& subject : subjects) {
      const auto routine = subject.routines.find(function);
      if (routine == subject.routines.end()) continue;
      const std::string name = robot.robot + '/' + name_of(function) + '/' + subject.implementation;
      for (const Mode mode : kModes) {
        register_mode(name, robot, function, routine->second, mode);
      }
    }
  }
}

}  // namespace treeline::bench
