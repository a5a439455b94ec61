#pragma once

// How references of `DriveController` wait for the robot; included by its header.

namespace treeline::drive {

/// Compares what is led with its references, for `servo::find_left_behind`. A hand and obstacles
/// may push the robot away, and so does what is left of another control: it then has some time to
/// come back.
template <class F>
template <class Visit>
void DriveController<F>::compare(double time, Visit&& visit) const noexcept {
  if (settings_.waits && time >= excused_until_) for_each_reference(visit);
}

/// Calls visit(error, velocity or -1, since, duration) for each reference that is to be followed.
template <class F>
template <class Visit>
void DriveController<F>::for_each_reference(Visit&& visit) const noexcept {
  for (int k = 0; k < kPoints && control_ == Control::task; ++k) {
    if (free_[at(k)]) continue;
    const SmoothNumber& last = points_[at(k)].last();
    visit(away_[at(k)], -1, last.since(), last.duration());
  }
  if (control_ == Control::task) return;
  for_each_joint(
      [&](int iq, int iv) {
        if (control_ != Control::joint || is_passive(iv)) return;
        const SmoothNumber& goal = joints_[at(iq)];
        visit(std::fabs(way(iv, state_.q[iq], goal.position())), iv, goal.since(), goal.duration());
      },
      [&](int k, int iq, int iv) {
        if (is_passive(iv)) return;
        const SmoothNumber& last = floating_[at(k)].last();
        double error[6];
        find_base_error(floating_[at(k)], state_.q + iq, error);
        visit(servo::away_of(error, {true, true, true, true, true, true}), -1, last.since(),
              last.duration());
      });
}

/// References go slower, and stand, where the robot stays behind. What a hand, obstacles or a
/// change of the control have led away, and does not come back in time, holds where it is.
template <class F>
void DriveController<F>::wait_for_robot(double time) noexcept {
  if (!settings_.waits) return;
  using Waiting = core::EmittedWaiting<double>;
  constexpr double kRecovery = 2.0;  // s
  const bool was_excused = excused_;
  const bool pushed = pulled() || avoidance_.pushes();
  if (pushed) excused_until_ = time + kRecovery;
  if (blend_asked_) excused_until_ = std::fmax(excused_until_, time + kBlend);
  excused_ = time < excused_until_;
  const typename Waiting::TlConfig config{settings_.period, settings_.following, 0.0};
  double away = 0.0;
  double share = 0.0;  // of what is admitted
  for_each_reference([&](double error, int, double since, double duration) {
    away = std::fmax(away, error);
    share = std::fmax(share, error / Waiting::tl_admitted_error(&config, since, 1.0 / duration));
  });
  const bool moves = moving(time, 1.0);
  behind_ = pushed || reference_.playing() ? 0.0 : Waiting::tl_behind(&config, away);
  const bool waits = moves && !excused_ && Waiting::tl_is_waiting(behind_);
  waited_ = waits ? waited_ + 1 : 0;
  if (Waiting::tl_has_waited(&config, waited_)) end_waiting(time);
  const bool came_back = !was_excused || excused_ || share <= 0.5;
  const bool keeps_up = !moves || excused_ || reference_.playing() || share <= 0.8;
  if (!came_back || !keeps_up) hold_here(time);
}

/// Where something holds a joint against a good part of its torque, it is blocked. Else nothing
/// leads on, as out of reach, or motors are too weak: the robot holds what it has come to. What
/// presses in closed loops is not known.
template <class F>
void DriveController<F>::end_waiting(double time) noexcept {
  constexpr double kPressed = 0.2;  // of the limit of torque
  constexpr double kStands = 0.05;  // rad/s or m/s
  constexpr bool kHasLoops = requires { F::kHeldRows; };
  waited_ = 0;
  double weight[nv];
  find_weight(state_.q, weight);
  for (int i = 0; i < nv; ++i) {
    const double most = kPressed * settings_.torque[at(i)];
    const double pressed = std::fabs(last_torque_[i] - weight[i]);
    const bool stands = std::fabs(state_.qd[i]) < kStands;
    if (kHasLoops || !stands || !(pressed > most)) continue;
    blocked_ = {servo::FaultKind::blocked, i, pressed, most};
    return;
  }
  hold_here(time);
}

template <class F>
void DriveController<F>::hold_here(double time) noexcept {
  const auto free = free_;
  begin_joints(time, state_);
  begin_points(time, state_);
  free_ = free;
  behind_ = 0.0;
  blend_asked_ = true;
}

}  // namespace treeline::drive
