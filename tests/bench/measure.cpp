#include "measure.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <span>

#include "evict.hpp"

namespace treeline::bench {
namespace {

constexpr int kStates = 64;
constexpr int kColdCalls = 16;  ///< in a repetition

/// The inputs of one function in 64 states, and room for its output.
struct Inputs {
  std::vector<State> states;
  std::array<std::array<const double*, 4>, kStates> pointers{};
  std::vector<double> output;

  Inputs(const Case& robot, Function function)
      : states(random_states(robot, kStates, 1)),
        output(static_cast<std::size_t>(output_size(function, robot))) {
    for (std::size_t i = 0; i < kStates; ++i) {
      const auto inputs = inputs_of(function, states[i]);
      for (std::size_t k = 0; k < inputs.size(); ++k) pointers[i][k] = inputs[k]->data();
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
  const std::size_t size = inputs.states[0].q.size();
  std::vector<double> q(size);
  std::array<const double*, 4> in{};
  while (run.KeepRunningBatch(kStates)) {
    for (std::size_t i = 0; i < kStates; ++i) {
      // Too small to change a digit; the processor cannot know.
      const double nothing = 1e-300 * (inputs.output.front() + inputs.output.back());
      for (std::size_t k = 0; k < size; ++k) q[k] = inputs.states[i].q[k] + nothing;
      in = inputs.pointers[i];
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

void evicted(benchmark::State& run, const Routine& routine, Inputs inputs, Mode mode) {
  std::size_t i = 0;
  for (auto _ : run) {
    const State& state = inputs.states[i % kStates];
    const std::array<std::span<const double>, 6> data{state.q,   state.qd,  state.qdd,
                                                      state.tau, state.xdd, inputs.output};
    if (mode == Mode::cold) {
      evict_from_core();
    } else if (!evict_from_caches(data)) {
      run.SkipWithError("no instruction to flush a cache line");
      break;
    }
    const double* const* in = inputs.pointers[i % kStates].data();
    run.SetIterationTime(seconds_of_one_call(routine, in, inputs.output.data()));
    ++i;
  }
}

void register_mode(const std::string& name, const Case& robot, Function function,
                   const Routine& routine, Mode mode) {
  const bool cold = mode == Mode::cold || mode == Mode::flushed;
  const auto body = [&robot, &routine, function, mode, cold](benchmark::State& run) {
    Inputs inputs(robot, function);
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
