// Times and iterations of limited_control_torque of a humanoid with two feet and two hands.
// Usage: report_limits [states]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "draw_humanoid.hpp"

namespace {

using namespace treeline::test;  // NOLINT: the states

double microseconds(const Asked& asked, humanoid::LimitedTorque& limited, int times) {
  const humanoid::LimitedTorque start = limited;
  double best = 1e9;
  for (int i = 0; i < times; ++i) {
    limited = start;
    double tau[kRates], f[kHeldRows];
    const auto before = std::chrono::steady_clock::now();
    humanoid::limited_control_torque(asked.q, asked.qd, asked.qdd_0, asked.xdd_cmd, asked.f_wanted,
                                     tau, f, limited);
    const auto after = std::chrono::steady_clock::now();
    best = std::min(best, std::chrono::duration<double, std::micro>(after - before).count());
  }
  return best;
}

struct Slow {
  double time;
  Asked asked;
};

/// The slowest states, timed again: what interrupted the machine has not slowed them twice.
double slowest(std::vector<Slow>& slow) {
  double worst = 0;
  for (const Slow& each : slow) {
    humanoid::LimitedTorque limited = {};
    worst = std::max(worst, microseconds(each.asked, limited, 20));
  }
  return worst;
}

void report(double size, int states) {
  std::mt19937_64 engine(7);
  std::vector<double> times;
  std::vector<Slow> slow;
  int limited_states = 0, widened = 0, unsolved = 0, most = 0;
  for (int i = 0; i < states; ++i) {
    const Asked asked = draw_humanoid(engine, size);
    humanoid::LimitedTorque limited = {};
    times.push_back(microseconds(asked, limited, 2));
    limited_states += limited.limited ? 1 : 0;
    widened += limited.slack > 1e-6 ? 1 : 0;
    unsolved += limited.status == humanoid::kSolved ? 0 : 1;
    most = std::max(most, limited.iterations);
    slow.push_back({times.back(), asked});
    if (slow.size() < 1000) continue;
    std::nth_element(slow.begin(), slow.begin() + 200, slow.end(),
                     [](const Slow& a, const Slow& b) { return a.time > b.time; });
    slow.resize(200);
  }
  std::nth_element(times.begin(), times.begin() + states / 2, times.end());
  std::printf("%4.1f %9d %9d %8d %9d %11d %12.1f %11.1f\n", size, states, limited_states, widened,
              unsolved, most, times[static_cast<std::size_t>(states / 2)], slowest(slow));
}

}  // namespace

int main(int argc, char** argv) {
  const int states = argc > 1 ? std::max(1, std::atoi(argv[1])) : 100000;
  std::printf("size    states   limited  widened  unsolved  iterations  median (us)  worst (us)\n");
  for (const double size : {0.05, 0.2, 1.0, 3.0}) report(size, states);
  return 0;
}
