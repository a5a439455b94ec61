// Which pose is the hardest to hold? Looks at a million of them, eight in each call.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>

#include "arms_batch.hpp"
#include "arms_joints.hpp"

int main() {
  constexpr int kCalls = 125000, kStates = arms::batch::kStates;
  double q[6][kStates], g[6][kStates], load[10][kStates] = {}, hardest[6] = {}, pose[6] = {};
  for (int k = 0; k < kStates; ++k) {  // 10 kg at 0.1 m before the flange: m, m c, tensor
    load[0][k] = 10;
    load[3][k] = 1;
    load[4][k] = load[6][k] = 0.1;
  }
  std::mt19937 random;
  std::chrono::nanoseconds busy{};
  for (int call = 0; call < kCalls; ++call) {
    for (int i = 0; i < 6; ++i) {
      const double range = arms::kUpperLimits[i] - arms::kLowerLimits[i];
      for (double& angle : q[i])
        angle = arms::kLowerLimits[i] + range * (static_cast<double>(random()) / 4294967296.0);
    }
    const auto begin = std::chrono::steady_clock::now();
    arms::batch::gravity(q, load, g);
    busy += std::chrono::steady_clock::now() - begin;
    for (int i = 0; i < 6; ++i) {
      for (int k = 0; k < kStates; ++k) {
        const double share = std::fabs(g[i][k]) / arms::kEffortLimits[i];
        if (share <= hardest[i]) continue;
        hardest[i] = share;
        for (int j = 0; j < 6 && i == 1; ++j) pose[j] = q[j][k];
      }
    }
  }
  for (int i = 0; i < 6; ++i) {
    std::fprintf(stderr, "%s needs %.0f %% of its torque at most\n", arms::kVelocityJoints[i],
                 100 * hardest[i]);
  }
  std::fprintf(stderr, "%.1f ns for a pose\n",
               static_cast<double>(busy.count()) / (kCalls * kStates));
  for (int j = 0; j < 6; ++j) std::printf(j < 5 ? "%.3f," : "%.3f\n", pose[j]);
}
