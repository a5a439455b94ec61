// Time of the sines and cosines of a robot's N joint angles: by libm one by one, by the scalar
// function one by one, by the lanes. `/warm` measures throughput (64 sets of angles in a row),
// `/dependent` feeds each call's result into the next angles. The counter `per_pair` is the time of
// one sine and cosine.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <random>

#include "core/sin_cos.hpp"

namespace {

constexpr int kSets = 64;

template <int N, class Real>
struct Angles {
  Real values[kSets][N];
  Angles() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> joint(-3.0, 3.0);
    for (auto& set : values) {
      for (Real& angle : set) {
        angle = static_cast<Real>(joint(random));
      }
    }
  }
};

struct Libm {
  template <int N, class Real>
  static void evaluate(const Real (&x)[N], Real (&s)[N], Real (&c)[N]) {
    for (int i = 0; i < N; ++i) {
      s[i] = std::sin(x[i]);
      c[i] = std::cos(x[i]);
    }
  }
};

struct OneByOne {
  template <int N, class Real>
  static void evaluate(const Real (&x)[N], Real (&s)[N], Real (&c)[N]) {
    for (int i = 0; i < N; ++i) {
      treeline::core::sin_cos(x[i], s[i], c[i]);
    }
  }
};

struct Together {
  template <int N, class Real>
  static void evaluate(const Real (&x)[N], Real (&s)[N], Real (&c)[N]) {
    treeline::core::sin_cos(x, s, c);
  }
};

void report_pairs(benchmark::State& state, int pairs_per_iteration) {
  state.counters["per_pair"] =
      benchmark::Counter(pairs_per_iteration, benchmark::Counter::kIsIterationInvariantRate |
                                                  benchmark::Counter::kInvert);
}

template <class Method, int N, class Real>
void warm(benchmark::State& state) {
  static const Angles<N, Real> angles;
  Real s[N];
  Real c[N];
  for (auto _ : state) {
    for (const auto& set : angles.values) {
      Method::evaluate(set, s, c);
      benchmark::DoNotOptimize(s);
      benchmark::DoNotOptimize(c);
    }
  }
  report_pairs(state, kSets * N);
}

template <class Method, int N, class Real>
void dependent(benchmark::State& state) {
  static const Angles<N, Real> angles;
  Real x[N];
  Real s[N];
  Real c[N] = {};
  for (auto _ : state) {
    for (const auto& set : angles.values) {
      for (int i = 0; i < N; ++i) {
        x[i] = set[i] + c[0];
      }
      Method::evaluate(x, s, c);
      benchmark::DoNotOptimize(s);
      benchmark::DoNotOptimize(c);
    }
  }
  report_pairs(state, kSets * N);
}

BENCHMARK(warm<Libm, 6, double>);
BENCHMARK(warm<OneByOne, 6, double>);
BENCHMARK(warm<Together, 6, double>);
BENCHMARK(warm<Libm, 24, double>);
BENCHMARK(warm<OneByOne, 24, double>);
BENCHMARK(warm<Together, 24, double>);
BENCHMARK(dependent<Libm, 6, double>);
BENCHMARK(dependent<Together, 6, double>);
BENCHMARK(dependent<Libm, 24, double>);
BENCHMARK(dependent<Together, 24, double>);
BENCHMARK(warm<Libm, 6, float>);
BENCHMARK(warm<Together, 6, float>);
BENCHMARK(warm<Libm, 24, float>);
BENCHMARK(warm<Together, 24, float>);

}  // namespace
