#pragma once

// How `DriveController` keeps joints within their limits; included by its header.

namespace treeline::drive {

/// Of a number that goes from `from` to `to`: how far it can go within [least, most], from 0 to 1.
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

/// The least and the most acceleration of a joint that stays below a share of its limit of speed.
template <class F>
std::array<double, 2> DriveController<F>::speed_range(const JointBounds& bounds, const State& state,
                                                      int iv) const noexcept {
  const double fastest = bounds.share * std::fmin(settings_.velocity[at(iv)], bounds.fastest);
  return {2.0 * limit_rate() * (-fastest - state.qd[iv]),
          2.0 * limit_rate() * (fastest - state.qd[iv])};
}

/// Bounds accelerations: each joint comes to rest before its limit of position, and stays below a
/// share of its limit of speed. One that is beyond is not thrown back. Returns whether one was
/// changed.
template <class F>
bool DriveController<F>::stay_within(const JointBounds& bounds, const State& state,
                                     double (&qdd)[nv]) const noexcept {
  const double rate = limit_rate();
  bool changed = false;
  for_each_joint(
      [&](int iq, int iv) {
        const double range = settings_.upper[at(iq)] - settings_.lower[at(iq)];
        const double margin = std::fmin(bounds.margin, 0.1 * range);
        const double to_upper = std::fmax(settings_.upper[at(iq)] - margin - state.q[iq], -margin);
        const double to_lower = std::fmin(settings_.lower[at(iq)] + margin - state.q[iq], margin);
        const double stopping = 2.0 * rate * state.qd[iv];
        const auto [least, most] = speed_range(bounds, state, iv);
        const double bounded =
            std::fmax(std::fmax(rate * rate * to_lower - stopping, least),
                      std::fmin(std::fmin(rate * rate * to_upper - stopping, most), qdd[iv]));
        changed = changed || bounded != qdd[iv];
        qdd[iv] = bounded;
      },
      [](int, int, int) {});
  return changed;
}

/// Bounds the accelerations that forces mean.
template <class F>
void DriveController<F>::bound_joints(const State& state, double (&tau)[nv]) const noexcept {
  double qdd[nv];
  F::forward_dynamics(state.q, state.qd, tau, qdd);
  if (stay_within(kTaskBounds, state, qdd)) {
    F::inverse_dynamics(state.q, state.qd, qdd, tau);
  }
}

/// Bounds what a task asks of the joints, so that no goal, singular or out of reach, makes a joint
/// exceed a limit. Where one would be too fast, all give way to braking, as far as it takes: the
/// robot then follows more slowly, on the way that the task means. If each were cut by itself,
/// joints that are coupled would run away. Those that do not move the points, by the Jacobian `J`,
/// are cut by themselves, as fingers are: the others need not wait for them.
template <class F>
void DriveController<F>::bound_task(const State& state, const double* J,
                                    double (&tau)[nv]) noexcept {
  constexpr double kBraking = 10.0;  // 1/s
  double qdd[nv];
  F::forward_dynamics(state.q, state.qd, tau, qdd);
  double braking[nv];
  std::copy_n(qdd, nv, braking);
  bool shares[nv] = {};
  double share = 1.0;
  for_each_joint(
      [&](int, int iv) {
        for (int row = 0; row < F::kTaskRows; ++row) {
          shares[iv] = shares[iv] || J[row * nv + iv] != 0.0;
        }
        const auto [least, most] = speed_range(kTaskBounds, state, iv);
        braking[iv] = -kBraking * state.qd[iv];
        qdd[iv] = std::isfinite(qdd[iv]) ? qdd[iv] : braking[iv];
        if (shares[iv]) share = std::fmin(share, share_within(least, most, braking[iv], qdd[iv]));
      },
      [](int, int, int) {});
  blend_numbers(share, braking, qdd);
  if (stay_within(kTaskBounds, state, qdd) || share < 1.0) {
    F::inverse_dynamics(state.q, state.qd, qdd, tau);
  }
  share_torque(state, braking, shares, tau);
}

/// Where one of the joints that share would need more than its limit of torque, all give way to
/// `braking`, which are accelerations.
template <class F>
void DriveController<F>::share_torque(const State& state, const double (&braking)[nv],
                                      const bool (&shares)[nv], double (&tau)[nv]) noexcept {
  for (int i = 0; i < nv; ++i) {
    slowed_ = slowed_ || (shares[i] && std::fabs(tau[i]) > settings_.torque[at(i)]);
  }
  if (!slowed_) {
    return;
  }
  double rest[nv];
  F::inverse_dynamics(state.q, state.qd, braking, rest);
  double share = 1.0;
  for (int i = 0; i < nv; ++i) {
    const double limit = settings_.torque[at(i)];
    if (shares[i]) share = std::fmin(share, share_within(-limit, limit, rest[i], tau[i]));
  }
  blend_numbers(share, rest, tau);
}

}  // namespace treeline::drive
