#include "trot_controller.hpp"

#include <algorithm>
#include <cmath>

#include "anymal_simulated_joints.hpp"
#include "core/command_laws.hpp"
#include "core/orientation.hpp"
#include "core/prioritized_solve.hpp"

namespace treeline::experiments {
namespace {

namespace robot = anymal_simulated;
constexpr int kRates = TrotController::kRates;
constexpr double kDiagonal = 0.65;  ///< of the scenes' task axes, rad
constexpr core::Gains<double> kBody{150.0, 24.0}, kTurn{300.0, 34.0}, kSwing{1600.0, 80.0};

void rotation_of(const AnymalState& state, double (&R)[9]) noexcept {
  const double quaternion[4] = {state.q[3], state.q[4], state.q[5], state.q[6]};
  core::rotation_from_quaternion(quaternion, R);
}

/// v = R u, or R^T u.
void turn(const double (&R)[9], const double* u, bool back, double (&v)[3]) noexcept {
  for (int i = 0; i < 3; ++i) {
    v[i] = 0.0;
    for (int k = 0; k < 3; ++k) v[i] += (back ? R[3 * k + i] : R[3 * i + k]) * u[k];
  }
}

/// Turns the horizontal part of accelerations, linear over angular, into axes turned by `angle`.
void turn_axes(double angle, double (&xdd)[6]) noexcept {
  const double c = std::cos(angle), s = std::sin(angle);
  for (double* part : {xdd, xdd + 3}) {
    const double x = part[0], y = part[1];
    part[0] = c * x + s * y;
    part[1] = c * y - s * x;
  }
}

}  // namespace

double weight_of_anymal() noexcept {
  double M[kRates * kRates];
  anymal_stand::mass_matrix(robot::kHome, M);
  return 9.81 * M[0];
}

void TrotController::start(double time, const AnymalState& state) noexcept {
  begin_ = time;
  planned_step_ = -1;
  weight_ = weight_of_anymal();
  double com[3];
  anymal_simulated::center_of_mass(state.q, com);
  AnymalOnFeet::place_feet(state.q, places_);
  std::copy_n(state.q, 3, body_);
  for (std::size_t k = 0; k < 2; ++k) {
    double middle = 0.0;
    for (const auto& place : places_) middle += place[k] / kFeet;
    shift_[k] = middle - com[k];
    for (auto& place : places_) place[k] -= body_[k] + shift_[k];
  }
}

void TrotController::apply(double, const servo::Message&) noexcept {}

/// Feet of the other pair leave their places for where the body will pass over them.
void TrotController::plan_swing(double time, const Vectors& feet) noexcept {
  planned_step_ = command_.phase.step;
  const double landing = time - command_.phase.since + plan_.swing;
  const double way = way_at(plan_, landing + plan_.loading + 0.5 * plan_.swing).position[0];
  for (std::size_t foot = 0; foot < feet.size(); ++foot) {
    const double from[2] = {feet[foot][0], feet[foot][1]};
    const double to[2] = {body_[0] + shift_[0] + way + places_[foot][0],
                          body_[1] + shift_[1] + places_[foot][1]};
    swings_[foot] = core::rest_to_rest<2>(from, to, plan_.swing);
  }
}

/// The body follows its path, upright. Accelerations are those of its own axes' velocities.
void TrotController::ask_body(double time, const AnymalState& state, double (&xdd)[6]) noexcept {
  constexpr double kUpright[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  double R[9], v[3], omega[3], turned[3], world[6];
  rotation_of(state, R);
  turn(R, state.qd, false, v);
  turn(R, state.qd + 3, false, omega);
  core::orientation_error(R, kUpright, turned);
  const auto way = way_at(plan_, time);
  const double amid = core::smooth_step(time / plan_.stand);
  const double wanted[3] = {body_[0] + amid * shift_[0] + way.position[0],
                            body_[1] + amid * shift_[1], body_[2]};
  for (int i = 0; i < 3; ++i) {
    command_.away[i] = state.q[i] - wanted[i];
    const double rate = i == 0 ? way.velocity[0] : 0.0;
    const double ahead = i == 0 ? way.acceleration[0] : 0.0;
    world[i] = ahead + kBody.kv * (rate - v[i]) - kBody.kp * command_.away[i];
    world[3 + i] = kTurn.kp * turned[i] - kTurn.kv * omega[i];
  }
  double linear[3], angular[3], cross[3];
  turn(R, world, true, linear);
  turn(R, world + 3, true, angular);
  const double rates[2][3] = {{state.qd[3], state.qd[4], state.qd[5]},
                              {state.qd[0], state.qd[1], state.qd[2]}};
  core::steps::cross(rates[0], rates[1], cross);
  for (int i = 0; i < 3; ++i) {
    xdd[i] = linear[i] - cross[i];
    xdd[3 + i] = angular[i];
  }
}

/// A swinging foot follows its path: along the ground a cubic, above it a bump.
void TrotController::ask_foot(int foot, double time, const Vectors& x, const Vectors& v,
                              double* xdd) noexcept {
  const auto at = static_cast<std::size_t>(foot);
  const double u = std::min(1.0, time / plan_.swing);
  const double rate = 1.0 / plan_.swing;
  const auto along = swings_[foot].at(time);
  const double left = 1.0 - u;
  const double lift = 16.0 * plan_.lift;
  const double height = lift * u * u * left * left;
  const double climb = 2.0 * lift * u * left * (left - u) * rate;
  const double bend = 2.0 * lift * (1.0 - 6.0 * u * left) * rate * rate;
  const double wanted[3] = {along.position[0], along.position[1], height};
  const double velocity[3] = {along.velocity[0], along.velocity[1], climb};
  const double acceleration[3] = {along.acceleration[0], along.acceleration[1], bend};
  double square = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double error = wanted[i] - x[at][i];
    xdd[i] = acceleration[i] + kSwing.kv * (velocity[i] - v[at][i]) + kSwing.kp * error;
    square += error * error;
  }
  command_.swing_error = std::max(command_.swing_error, std::sqrt(square));
}

/// Share of the weight: while all feet stand, it moves from the pair that stood to the next one.
double TrotController::wanted_load(int foot) const noexcept {
  const TrotPhase& phase = command_.phase;
  const auto share_at = [this, foot](int step) {
    const bool stands = step < 0 || step >= plan_.steps();
    return stands ? 0.25 : (carries(pair_of(step), foot) ? 0.5 : 0.0);
  };
  if (phase.support != Support::all) return weight_ * share_at(phase.step);
  if (phase.step < 0) return weight_ * 0.25;
  const double done = core::smooth_step(phase.since / plan_.loading);
  return weight_ * ((1.0 - done) * share_at(phase.step - 1) + done * share_at(phase.step));
}

/// Calls the law of one scene and says what it came to.
template <int held, class Law, class Limits, class Limited, int rows>
void TrotController::obey(const Law& law, const Limits& limits, Limited& limited,
                          const double (&xdd)[rows], const AnymalState& state,
                          double (&tau)[kRates]) noexcept {
  const double qdd_0[kRates] = {};
  double f_wanted[held] = {};
  double f[held];
  int at = 0;
  for (int foot = 0; foot < kFeet; ++foot) {
    if (carries(command_.phase.support, foot)) f_wanted[3 * at++ + 2] = wanted_load(foot);
  }
  law(state.q, state.qd, qdd_0, xdd, f_wanted, tau, f, limited, limits);
  command_.within = limit_figures(tau, robot::kEffortLimits, f, limits, limited);
}

void TrotController::stand(const double (&body)[6], const AnymalState& state,
                           double (&tau)[kRates]) noexcept {
  const auto law = [](auto&... arguments) noexcept {
    anymal_stand::limited_control_torque(arguments...);
  };
  obey<12>(law, anymal_stand::kTorqueLimits, on_all_, body, state, tau);
}

/// Two feet carry, and the other two follow their paths. Across the line between feet that carry
/// nothing is asked of the body.
void TrotController::swing(double (&body)[6], const Vectors& x, const Vectors& v,
                           const AnymalState& state, double (&tau)[kRates]) noexcept {
  const bool on_left = command_.phase.support == Support::left;
  turn_axes(on_left ? kDiagonal : -kDiagonal, body);
  double xdd[11] = {body[0], body[2], body[3], body[4], body[5]};
  double* next = xdd + 5;
  command_.swing_error = 0.0;
  for (int foot = 0; foot < kFeet; ++foot) {
    if (carries(command_.phase.support, foot)) continue;
    ask_foot(foot, command_.phase.since, x, v, next);
    next += 3;
  }
  if (on_left) {
    const auto law = [](auto&... arguments) noexcept {
      anymal_left::limited_control_torque(arguments...);
    };
    obey<6>(law, anymal_left::kTorqueLimits, on_left_, xdd, state, tau);
  } else {
    const auto law = [](auto&... arguments) noexcept {
      anymal_right::limited_control_torque(arguments...);
    };
    obey<6>(law, anymal_right::kTorqueLimits, on_right_, xdd, state, tau);
  }
}

void TrotController::control(double time, const AnymalState& state,
                             double (&tau)[kRates]) noexcept {
  const double since = time - begin_;
  command_.phase = phase_at(plan_, since);
  double body[6];
  ask_body(since, state, body);
  if (command_.phase.support == Support::all) {
    stand(body, state, tau);
    return;
  }
  Vectors x, v;
  AnymalOnFeet::ground_points(state.q, state.qd, x, v);
  if (planned_step_ != command_.phase.step) plan_swing(since, x);
  swing(body, x, v, state, tau);
}

}  // namespace treeline::experiments
