#pragma once

// How `DriveController` keeps joints within their limits; included by its header.

namespace treeline::drive {

/// Share, from 0 to 1, of the way from `from` to `to` that stays within [least, most].
inline double share_within(double least, double most, double from, double to) noexcept {
  const double border = to > most ? most : least;
  if (!(to > most || to < least) || from == to) {
    return 1.0;
  }
  return std::fmin(std::fmax((border - from) / (to - from), 0.0), 1.0);
}

/// Leaves `share` of what `to` is beyond `from`.
template <std::size_t n>
void blend_numbers(double share, const double (&from)[n], double (&to)[n]) noexcept {
  for (std::size_t i = 0; i < n; ++i) {
    to[i] = from[i] + share * (to[i] - from[i]);
  }
}

/// Accelerates joints away from limits that they come close to, as a damped spring would.
template <class F>
void DriveController<F>::push_from_limits(const State& state, double (&qdd)[nv]) const noexcept {
  constexpr double kZone = 0.08;  // rad or m, at most a tenth of the range
  const double stiffness = std::fmin(3000.0, 0.01 / (settings_.period * settings_.period));
  const double damping = 2.0 * std::sqrt(stiffness);
  for_each_joint(
      [&](int iq, int iv) {
        const double lower = settings_.lower[at(iq)];
        const double upper = settings_.upper[at(iq)];
        const double zone = std::fmin(kZone, 0.1 * (upper - lower));
        const double low = lower + zone - state.q[iq];
        const double high = state.q[iq] - upper + zone;
        if (low > 0.0 || high > 0.0) {
          const double depth = low > 0.0 ? low : -high;
          const double away = state.qd[iv] * depth;  // positive: it leaves the limit already
          qdd[iv] += stiffness * depth - (away < 0.0 ? damping * state.qd[iv] : 0.0);
        }
      },
      [](int, int, int) {});
}

/// Compares how the robot moves with what the model says of the torques that it was given, by an
/// observer of the first order. What is left is of masses, friction and hands that the model does
/// not know.
template <class F>
void DriveController<F>::observe(const State& state) noexcept {
  double qdd[nv];
  F::forward_dynamics(state_.q, state_.qd, last_torque_, qdd);
  for (int i = 0; i < nv; ++i) {
    foreseen_[i] += settings_.period * (qdd[i] + unforeseen_[i]);
    if (!std::isfinite(foreseen_[i])) foreseen_[i] = state.qd[i];
    unforeseen_[i] = 2.0 * limit_rate() * (state.qd[i] - foreseen_[i]);
  }
}

/// Bounds of a joint's acceleration by the model, from those of its true one: what the model does
/// not know and pushes towards a bound is left room for, what holds back is not counted on.
template <class F>
std::array<double, 2> DriveController<F>::leave_room(double least, double most,
                                                     int iv) const noexcept {
  const double pushed = unforeseen_[iv];
  if (pushed > 0.0) return {std::fmin(least, most - pushed), most - pushed};
  return {least - pushed, std::fmax(most, least - pushed)};
}

/// The least and the most acceleration of a joint that stays below a share of its limit of speed.
/// It nears that limit more slowly than `observe` finds what the model does not know.
template <class F>
std::array<double, 2> DriveController<F>::speed_range(const JointBounds& bounds, const State& state,
                                                      int iv) const noexcept {
  const double fastest = bounds.share * std::fmin(settings_.velocity[at(iv)], bounds.fastest);
  const auto most = [&](double speed) {
    const double room = fastest - speed;
    return room > 0.0 ? room / kRise : 2.0 * limit_rate() * room;
  };
  return leave_room(-most(-state.qd[iv]), most(state.qd[iv]), iv);
}

/// Bounds accelerations: each joint comes to rest before its limit of position, so slowly that the
/// share `brakes` of `limit_rate` is enough, and stays below a share of its limit of speed. One
/// that is beyond is not thrown back. Returns whether one was changed.
template <class F>
bool DriveController<F>::stay_within(const JointBounds& bounds, double brakes, const State& state,
                                     double (&qdd)[nv]) const noexcept {
  const double rate = limit_rate();
  bool changed = false;
  for_each_joint(
      [&](int iq, int iv) {
        if (is_passive(iv)) return;
        const double range = settings_.upper[at(iq)] - settings_.lower[at(iq)];
        const double margin = std::fmin(bounds.margin, 0.1 * range);
        const double to_upper = std::fmax(settings_.upper[at(iq)] - margin - state.q[iq], -margin);
        const double to_lower = std::fmin(settings_.lower[at(iq)] + margin - state.q[iq], margin);
        const double stopping = 2.0 * rate * state.qd[iv];
        const double stiffness = rate * rate * brakes;
        const auto [least, most] = speed_range(bounds, state, iv);
        const auto [lowest, highest] =
            leave_room(stiffness * to_lower - stopping, stiffness * to_upper - stopping, iv);
        const double slow = std::fmax(least, std::fmin(most, qdd[iv]));
        const double bounded = std::fmax(lowest, std::fmin(highest, slow));
        changed = changed || bounded != qdd[iv];
        qdd[iv] = bounded;
      },
      [](int, int, int) {});
  return changed;
}

/// How the robot brakes here: all joints alike, qdd = -rate qd, by as much of `limit_rate` as
/// motors have torque for beside what bears its weight and speed; with them floating joints, which
/// ideal forces hold, since they take their limbs along. Motors too weak for the weight alone do
/// not count.
template <class F>
typename DriveController<F>::Braking DriveController<F>::find_braking(
    const State& state) const noexcept {
  Braking braking;
  const auto brake_by = [&](double rate, double(&tau)[nv]) {
    for (int i = 0; i < nv; ++i) braking.qdd[i] = -rate * state.qd[i];
    F::inverse_dynamics(state.q, state.qd, braking.qdd, tau);
  };
  find_weight(state.q, braking.weight);
  double rest[nv];
  brake_by(0.0, rest);
  brake_by(limit_rate(), braking.tau);
  for (int i = 0; i < nv; ++i) {
    const double limit = settings_.torque[at(i)];
    braking.bears[i] = !(std::fabs(braking.weight[i]) > limit);
    if (!braking.bears[i]) continue;
    braking.share = std::fmin(braking.share, share_within(-limit, limit, rest[i], braking.tau[i]));
  }
  blend_numbers(braking.share, rest, braking.tau);
  for (double& each : braking.qdd) each *= braking.share;
  return braking;
}

/// The torques that hold the robot at rest.
template <class F>
void DriveController<F>::find_weight(const double (&q)[nq], double (&weight)[nv]) noexcept {
  const double none[nv] = {};
  F::inverse_dynamics(q, none, none, weight);
}

/// Share of `qdd`, less braking, with which motors can bear the robot's weight where it comes to
/// rest if it is accelerated for a moment and then braked. They bear 95 % of their limit, or the
/// load that they bear here.
template <class F>
double DriveController<F>::share_that_is_borne(const State& state, const Braking& braking,
                                               const double (&qdd)[nv]) const noexcept {
  const double moment = 1.0 / limit_rate();
  const double stop = moment / std::fmax(braking.share, 0.1);
  double weights[2][nv];
  for (int k = 0; k < 2; ++k) {
    double way[nv];
    for (int i = 0; i < nv; ++i) {
      const double gained = k == 0 ? 0.0 : moment * qdd[i];
      way[i] = stop * state.qd[i] + (stop + 0.5 * moment) * gained;
    }
    double q[nq];
    servo::go_from<F>(state.q, way, q);
    find_weight(q, weights[k]);
  }
  double share = 1.0;
  for (int i = 0; i < nv; ++i) {
    const double most = std::fmax(0.95 * settings_.torque[at(i)], std::fabs(braking.weight[i]));
    share = std::fmin(share, share_within(-most, most, weights[0][i], weights[1][i]));
  }
  return share;
}

/// Brings the sum of all that was asked for within the limits. Where a joint that moves a point, by
/// the Jacobian `J`, would be too fast, or lacks torque, all give way to braking, as far as it
/// takes: the robot then follows more slowly, on the way that the task means. If each were cut by
/// itself, joints that are coupled would run away. Those that move no point, as fingers are, are
/// cut by themselves, and so are all where joints are led: `J` null. What then keeps limits of
/// position and speed takes torque again: where that is not there, all brake.
template <class F>
void DriveController<F>::keep_limits(const State& state, const double* J,
                                     double (&tau)[nv]) noexcept {
  double qdd[nv];
  F::forward_dynamics(state.q, state.qd, tau, qdd);
  const Braking braking = find_braking(state);
  bool shares[nv] = {};
  for (int i = 0; J != nullptr && i < task_rows() * nv; ++i) {
    shares[i % nv] = shares[i % nv] || J[i] != 0.0;
  }
  share_torque(braking, shares, tau);
  cut(tau);
  F::forward_dynamics(state.q, state.qd, tau, qdd);
  double share = 1.0;
  for_each_joint(
      [&](int, int iv) {
        const auto [least, most] = speed_range(kBounds, state, iv);
        qdd[iv] = std::isfinite(qdd[iv]) ? qdd[iv] : braking.qdd[iv];
        if (!shares[iv]) return;
        share = std::fmin(share, share_within(least, most, braking.qdd[iv], qdd[iv]));
      },
      [](int, int, int) {});
  share = std::fmin(share, share_that_is_borne(state, braking, qdd));
  blend_numbers(share, braking.qdd, qdd);
  if (stay_within(kBounds, braking.share, state, qdd) || share < 1.0) {
    F::inverse_dynamics(state.q, state.qd, qdd, tau);
    std::fill(std::begin(shares), std::end(shares), true);
    share_torque(braking, shares, tau);
  }
  // Where braking is nearly all that there is torque for, it is all that is done.
  constexpr double kLeast = 0.2;
  constexpr double kEnough = 0.5;
  const double left = (braking.share - kLeast) / (kEnough - kLeast);
  if (left < 1.0) blend_numbers(std::fmax(left, 0.0), braking.tau, tau);
  cut(tau);
}

/// Scales the torques towards braking, all of them alike, where one of the joints that share needs
/// more than its limit of torque.
template <class F>
void DriveController<F>::share_torque(const Braking& braking, const bool (&shares)[nv],
                                      double (&tau)[nv]) noexcept {
  double share = 1.0;
  for (int i = 0; i < nv; ++i) {
    const double limit = settings_.torque[at(i)];
    if (!shares[i] || !braking.bears[i]) continue;
    saturated_ = saturated_ || std::fabs(tau[i]) > limit;
    share = std::fmin(share, share_within(-limit, limit, braking.tau[i], tau[i]));
  }
  if (share < 1.0) blend_numbers(share, braking.tau, tau);
}

/// Cuts each torque to its limit.
template <class F>
void DriveController<F>::cut(double (&tau)[nv]) noexcept {
  for (int i = 0; i < nv; ++i) {
    const double limit = settings_.torque[at(i)];
    if (std::fabs(tau[i]) > limit) {
      saturated_ = true;
      tau[i] = tau[i] > 0.0 ? limit : -limit;
    }
  }
}

}  // namespace treeline::drive
