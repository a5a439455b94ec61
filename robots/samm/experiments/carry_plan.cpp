#include "carry_plan.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/orientation.hpp"

namespace treeline::experiments {
namespace {

constexpr double kHeight = 1.35;  // of the object at the start, m
constexpr double kPi = 3.14159265358979323846;

/// Start of the first robot: elbow up, flange 0.4 m behind the object. The second robot stands
/// opposite.
constexpr double kStart[kJoints] = {-1.15511, -0.302958, 0.0,       0.210695, -0.728762,
                                    2.549732, 0.712486,  -0.325648, -0.685896};

/// A function that goes from 0 at `begin` to 1 at `end`, at rest at both ends, and its rates.
struct Ramp {
  double s, sd, sdd;
};
Ramp ramp(double time, double begin, double end) {
  const double T = end - begin;
  const double x = std::clamp((time - begin) / T, 0.0, 1.0);
  const bool moves = time > begin && time < end;
  return {x * x * (3 - 2 * x), moves ? 6 * x * (1 - x) / T : 0.0,
          moves ? 6 * (1 - 2 * x) / (T * T) : 0.0};
}

}  // namespace

PairState start_state() {
  PairState state;
  for (int i = 0; i < kJoints; ++i) {
    state.q[0][i] = kStart[i];
    state.q[1][i] = i < 2 ? -kStart[i] : kStart[i];
  }
  state.q[1][2] = kPi;
  constexpr double kPosition[3] = {0.0, 0.0, kHeight};
  constexpr double kUpright[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  grasp_object(kPosition, kUpright, state);
  return state;
}

void advise(const CarryPlan& plan, const PairState& start, const PairState& state,
            const Wanted& wanted, double (&qdd_0)[2][kJoints]) {
  const double c = std::cos(wanted.yaw), s = std::sin(wanted.yaw);
  for (int robot = 0; robot < 2; ++robot) {
    double advised[kJoints];
    double rate[kJoints] = {};
    std::copy(std::begin(start.q[robot]), std::end(start.q[robot]), advised);
    const double arm[2] = {c * advised[0] - s * advised[1], s * advised[0] + c * advised[1]};
    advised[0] = wanted.position[0] + arm[0];
    advised[1] = wanted.position[1] + arm[1];
    advised[2] += wanted.yaw;
    rate[0] = wanted.velocity[0] - wanted.yaw_rate * arm[1];
    rate[1] = wanted.velocity[1] + wanted.yaw_rate * arm[0];
    rate[2] = wanted.yaw_rate;
    for (int i = 0; i < kJoints; ++i) {
      qdd_0[robot][i] = plan.posture * (advised[i] - state.q[robot][i]) +
                        2.0 * std::sqrt(plan.posture) * (rate[i] - state.qd[robot][i]);
    }
  }
}

Wanted wanted_at(const CarryPlan& plan, double time) {
  const Ramp round = ramp(time, plan.lead, plan.lead + plan.duration);
  const double angle = 2 * kPi * round.s, rate = 2 * kPi * round.sd;
  const double growth = 2 * kPi * round.sdd;
  const double s = std::sin(angle), c = std::cos(angle);
  // First and second time derivatives of sin and of 1 - cos.
  const double of_sin[3] = {s, c * rate, c * growth - s * rate * rate};
  const double of_cos[3] = {1 - c, s * rate, s * growth + c * rate * rate};
  Wanted wanted;
  const auto set = [&](int axis, double factor, const double(&terms)[3]) {
    wanted.position[axis] += factor * terms[0];
    wanted.velocity[axis] += factor * terms[1];
    wanted.acceleration[axis] += factor * terms[2];
  };
  wanted.position[2] = kHeight;
  set(0, plan.radius, of_sin);
  set(1, plan.radius, of_cos);
  set(2, plan.rise, of_cos);
  wanted.yaw = plan.yaw * of_sin[0];
  wanted.yaw_rate = plan.yaw * of_sin[1];
  wanted.velocity[5] = wanted.yaw_rate;
  wanted.acceleration[5] = plan.yaw * of_sin[2];
  const double vector[3] = {0.0, 0.0, wanted.yaw};
  core::rotation_from_vector(vector, wanted.rotation);
  wanted.internal[0] =
      -plan.squeeze_from - (plan.squeeze_to - plan.squeeze_from) * ramp(time, 3.0, 4.0).s;
  wanted.internal[1] = plan.torsion * ramp(time, 5.0, 6.0).s;
  return wanted;
}

}  // namespace treeline::experiments
