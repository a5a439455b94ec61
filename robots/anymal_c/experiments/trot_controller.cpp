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
constexpr double kDiagonal = 0.65;   ///< of the scenes' task axes, rad
constexpr double kLeastLoad = 20.0;  ///< of a foot that is held, beside 5 N of the scene, N
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

}  // namespace

double weight_of_anymal() noexcept {
  double M[kRates * kRates];
  anymal_trot::mass_matrix(robot::kHome, M);
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

/// Feet that swing have paths, others are held. On two feet the body is led along the line between
/// them alone.
void TrotController::obey(const double (&xdd)[anymal_trot::kTaskRows], const AnymalState& state,
                          double (&tau)[kRates]) noexcept {
  const double qdd_0[kRates] = {};
  double held[kFeet], done[2 + kFeet], f_wanted[3 * kFeet] = {}, f[3 * kFeet];
  done[0] = led_share(plan_, command_.phase, Support::left);
  done[1] = led_share(plan_, command_.phase, Support::right);
  anymal_trot::TorqueLimits limits = anymal_trot::kTorqueLimits;
  for (int foot = 0; foot < kFeet; ++foot) {
    held[foot] = held_share(plan_, command_.phase, foot);
    done[2 + foot] = 1.0 - held[foot];
    f_wanted[3 * foot + 2] = std::max(kLeastLoad, wanted_load(foot));
  }
  anymal_trot::limited_control_torque(state.q, state.qd, qdd_0, xdd, f_wanted, done, held, tau, f,
                                      limited_, limits);
  command_.beyond_in_part = 0.0;
  for (auto& cone : limits.cones) {
    const double share = held[cone.first / 3];
    if (share == 1.0) continue;
    double value = -share * cone.bound;
    for (int k = 0; k < cone.count; ++k) value += cone.coefficients[k] * f[cone.first + k];
    command_.beyond_in_part = std::max(command_.beyond_in_part, value);
    cone.bound = 1e30;
  }
  command_.within = limit_figures(tau, robot::kEffortLimits, f, limits, limited_);
  if (command_.beyond_in_part > 0.0) command_.within.slack = 0.0;  // other cones are not widened
  command_.torque_step = 0.0;
  for (int v = 0; v < kRates; ++v) {
    command_.torque_step = std::max(command_.torque_step, std::fabs(tau[v] - last_tau_[v]));
    last_tau_[v] = tau[v];
  }
}

void TrotController::control(double time, const AnymalState& state,
                             double (&tau)[kRates]) noexcept {
  const double since = time - begin_;
  command_.phase = phase_at(plan_, since);
  double body[6];
  ask_body(since, state, body);
  const double c = std::cos(kDiagonal), s = std::sin(kDiagonal);
  double xdd[anymal_trot::kTaskRows] = {
      body[2], body[3], body[4], body[5], c * body[0] + s * body[1], c * body[0] - s * body[1]};
  Vectors x, v;
  AnymalOnFeet::ground_points(state.q, state.qd, x, v);
  const bool swings = command_.phase.support != Support::all;
  if (swings && planned_step_ != command_.phase.step) plan_swing(since, x);
  command_.swing_error = 0.0;
  for (int foot = 0; swings && foot < kFeet; ++foot) {
    if (carries(command_.phase.support, foot)) continue;
    ask_foot(foot, command_.phase.since, x, v, xdd + 6 + 3 * foot);
  }
  obey(xdd, state, tau);
}

}  // namespace treeline::experiments
