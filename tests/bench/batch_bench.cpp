// States per second of generated batch functions. `/core` uses one thread on rows in cache;
// `/threads` uses all cores of the machine on 32768 states in memory, which are gathered into rows
// and scattered back. The result is the counter `states`; `scalar` is the same without batches.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "batch/transpose.hpp"
#include "bench_humanoid24_batch.hpp"
#include "bench_humanoid24f_batch.hpp"
#include "bench_puma560_batch.hpp"

namespace {

namespace human = bench_humanoid24;
namespace human_float = bench_humanoid24f;
namespace puma = bench_puma560;
using treeline::batch::Part;

template <class Real, int size, int states>
void fill(Real (&rows)[size][states], double phase) {
  for (int i = 0; i < size; ++i) {
    for (int k = 0; k < states; ++k) {
      rows[i][k] = static_cast<Real>(std::sin(phase + 1.3 * i + 0.7 * k));
    }
  }
}

/// Arguments of control_torque, which include those of inverse_dynamics.
template <class Real, int nv, int rows, int states>
struct Arguments {
  alignas(64) Real q[nv][states];
  alignas(64) Real qd[nv][states];
  alignas(64) Real qdd[nv][states];
  alignas(64) Real xdd[rows][states];
  alignas(64) Real tau[nv][states];
  Arguments() {
    fill(q, 0.1);
    fill(qd, 0.2);
    fill(qdd, 0.3);
    fill(xdd, 0.4);
  }
};

void count_states(benchmark::State& state, double states_a_turn) {
  state.counters["states"] =
      benchmark::Counter(states_a_turn, benchmark::Counter::kIsIterationInvariantRate);
}

template <class Args, class Call>
void run_core(benchmark::State& state, int states, Call call) {
  Args args;
  for (auto _ : state) {
    args.q[0][0] = args.q[0][0] + args.tau[0][0] * 0;
    call(args);
    benchmark::DoNotOptimize(args.tau);
    benchmark::ClobberMemory();
  }
  count_states(state, states);
}

using Puma = Arguments<double, puma::kVelocities, puma::kTaskRows, puma::batch::kStates>;
using Human = Arguments<double, human::kVelocities, human::kTaskRows, human::batch::kStates>;
using HumanFloat =
    Arguments<float, human_float::kVelocities, human_float::kTaskRows, human_float::batch::kStates>;

void puma_torque(benchmark::State& state) {
  run_core<Puma>(state, puma::batch::kStates,
                 [](Puma& a) { puma::batch::control_torque(a.q, a.qd, a.qdd, a.xdd, a.tau); });
}
BENCHMARK(puma_torque)->Name("puma560 control_torque, double/core");

void puma_rnea(benchmark::State& state) {
  run_core<Puma>(state, puma::batch::kStates,
                 [](Puma& a) { puma::batch::inverse_dynamics(a.q, a.qd, a.qdd, a.tau); });
}
BENCHMARK(puma_rnea)->Name("puma560 inverse_dynamics, double/core");

void human_torque(benchmark::State& state) {
  run_core<Human>(state, human::batch::kStates,
                  [](Human& a) { human::batch::control_torque(a.q, a.qd, a.qdd, a.xdd, a.tau); });
}
BENCHMARK(human_torque)->Name("humanoid24 control_torque, double/core");

void human_rnea(benchmark::State& state) {
  run_core<Human>(state, human::batch::kStates,
                  [](Human& a) { human::batch::inverse_dynamics(a.q, a.qd, a.qdd, a.tau); });
}
BENCHMARK(human_rnea)->Name("humanoid24 inverse_dynamics, double/core");

void human_float_torque(benchmark::State& state) {
  run_core<HumanFloat>(state, human_float::batch::kStates, [](HumanFloat& a) {
    human_float::batch::control_torque(a.q, a.qd, a.qdd, a.xdd, a.tau);
  });
}
BENCHMARK(human_float_torque)->Name("humanoid24 control_torque, float/core");

void human_scalar(benchmark::State& state) {
  Human rows;
  double q[human::kVelocities];
  double qd[human::kVelocities];
  double qdd[human::kVelocities];
  double xdd[human::kTaskRows];
  double tau[human::kVelocities] = {};
  scatter(rows.q, Part{0, 1}, q);
  scatter(rows.qd, Part{0, 1}, qd);
  scatter(rows.qdd, Part{0, 1}, qdd);
  scatter(rows.xdd, Part{0, 1}, xdd);
  for (auto _ : state) {
    q[0] = q[0] + tau[0] * 0;
    human::control_torque(q, qd, qdd, xdd, tau);
    benchmark::DoNotOptimize(tau);
    benchmark::ClobberMemory();
  }
  count_states(state, 1);
}
BENCHMARK(human_scalar)->Name("humanoid24 control_torque, double/scalar");

void human_threads(benchmark::State& state) {
  constexpr std::size_t kStates = 32768;
  constexpr std::size_t kPart = 256;
  constexpr int kLanes = human::batch::kStates;
  std::vector<double> q(kStates * human::kCoordinates, 0.3);
  std::vector<double> qd(kStates * human::kVelocities, 0.2);
  std::vector<double> xdd(kStates * human::kTaskRows, 0.1);
  std::vector<double> tau(kStates * human::kVelocities);
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = std::sin(1.3 * static_cast<double>(i % 1009));
  treeline::batch::Workers workers;
  const std::function<void(Part)> work = [&](Part part) {
    Human a;
    for (const std::size_t end = part.first + part.count; part.first < end; part.first += kLanes) {
      part.count = std::min<std::size_t>(kLanes, end - part.first);
      gather(q.data(), part, a.q);
      gather(qd.data(), part, a.qd);
      gather(qd.data(), part, a.qdd);
      gather(xdd.data(), part, a.xdd);
      human::batch::control_torque(a.q, a.qd, a.qdd, a.xdd, a.tau);
      scatter(a.tau, part, tau.data());
    }
  };
  for (auto _ : state) {
    workers.run(kStates, kPart, work);
    benchmark::ClobberMemory();
  }
  count_states(state, kStates);
  state.counters["threads"] = workers.threads();
}
BENCHMARK(human_threads)->Name("humanoid24 control_torque, double/threads")->UseRealTime();

}  // namespace
