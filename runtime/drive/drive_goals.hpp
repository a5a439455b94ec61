#pragma once

// How `DriveController` takes messages and sets its goals; included by its header.

namespace treeline::drive {

template <class F>
void DriveController<F>::set_control(double time, const State& state, Control wanted) noexcept {
  if (wanted == control_ || (wanted == Control::task && kPoints == 0)) {
    return;
  }
  control_ = wanted;
  begin_joints(time, state);
  begin_points(time, state);
  blend_asked_ = true;
}

template <class F>
void DriveController<F>::apply(double time, const servo::Message& message) noexcept {
  if (message.kind != servo::MessageKind::instruction) {
    return;
  }
  const auto instruction = static_cast<Instruction>(message.index);
  stop_following(time, instruction);
  switch (instruction) {
    case Instruction::set_control:
      set_control(time, state_, static_cast<Control>(static_cast<int>(message.values[0])));
      break;
    case Instruction::move_joint:
    case Instruction::move_posture:
    case Instruction::go_home:
    case Instruction::drag_joint:
      apply_to_joints(time, instruction, message);
      break;
    case Instruction::move_point:
    case Instruction::turn_point:
    case Instruction::drag_point:
    case Instruction::hold_point:
    case Instruction::release_point:
      apply_to_point(time, instruction, message);
      break;
    case Instruction::pull_link:
      begin_pull(time, message);
      break;
    case Instruction::hold_all:
      hold_all(time);
      break;
    case Instruction::set_gains:
      set_gains(message);
      break;
    case Instruction::begin_here:
      start(time, state_);
      break;
    case Instruction::follow:
      begin_following(time, message.duration);
      break;
  }
}

template <class F>
void DriveController<F>::apply_to_joints(double time, Instruction instruction,
                                         const servo::Message& message) noexcept {
  if (instruction != Instruction::move_posture) set_control(time, state_, Control::joint);
  if (instruction == Instruction::go_home) {
    go_home(time, message.duration);
  } else if (instruction == Instruction::drag_joint) {
    drag_joint(time, message);
  } else {
    move_joint(time, message);
  }
}

template <class F>
void DriveController<F>::apply_to_point(double time, Instruction instruction,
                                        const servo::Message& message) noexcept {
  const int index = static_cast<int>(message.values[0]);
  const bool is_point = index >= 0 && index < kPoints;
  if (instruction == Instruction::release_point) {
    if (!is_point) return;
    free_[at(index)] = true;
    blend_asked_ = true;
    return;
  }
  SmoothPose* const pose = pose_of(index);
  if (pose == nullptr) return;
  if (instruction == Instruction::move_point) move_pose(time, message, *pose);
  if (instruction == Instruction::turn_point) turn_pose(time, message, *pose);
  if (instruction == Instruction::drag_point) drag_pose(time, message, *pose);
  if (instruction == Instruction::hold_point) {
    pose->hold(time);
    if (is_point) free_[at(index)] = false;
  }
}

/// Joints move to where the reference begins, then along it. Floating joints stay.
template <class F>
void DriveController<F>::begin_following(double time, double duration) noexcept {
  if (!reference_.exists()) {
    return;
  }
  set_control(time, state_, Control::joint);
  double longest = 0.0;
  for_each_joint(
      [&](int iq, int iv) {
        const double distance =
            std::fabs(way(iv, joints_[at(iq)].position(), reference_.first(iq)));
        longest =
            std::fmax(longest, guess_duration(distance, settings_.velocity[at(iv)], duration));
      },
      [](int, int, int) {});
  longest = longest > 0.0 ? longest : kShortestGuess;
  for_each_joint(
      [&](int iq, int iv) {
        const double from = joints_[at(iq)].position();
        joints_[at(iq)].move(time, from + way(iv, from, reference_.first(iq)), longest);
      },
      [&](int k, int, int) { floating_[at(k)].hold(time); });
  reference_.begin(time + longest);
}

/// Every other instruction but that of gains ends it: the joints glide to rest.
template <class F>
void DriveController<F>::stop_following(double time, Instruction next) noexcept {
  if (!reference_.playing() || next == Instruction::set_gains) {
    return;
  }
  reference_.end();
  hold_all(time);
}

template <class F>
void DriveController<F>::follow_reference(double time) noexcept {
  if (!reference_.begun(time)) {
    return;
  }
  if (reference_.ended(time)) {
    reference_.end();
    hold_all(time);
    return;
  }
  reference_.seek(time);
  for_each_joint([&](int iq, int) { joints_[at(iq)].lead(time, reference_.sample(iq)); },
                 [](int, int, int) {});
}

template <class F>
SmoothPose* DriveController<F>::pose_of(int point) noexcept {
  if (point == kBasePoint) {
    return kFloating > 0 ? &floating_[0] : nullptr;
  }
  return point >= 0 && point < kPoints ? &points_[at(point)] : nullptr;
}

/// Duration of a motion over `distance`: as asked for, but not above the speed `limit`, nor nearing
/// it faster than `speed_range` lets a joint; without being asked, at half of it.
template <class F>
double DriveController<F>::guess_duration(double distance, double limit,
                                          double asked) const noexcept {
  const bool limited = std::isfinite(limit);
  const double fastest = limited ? kPeak * distance / (kLead * limit) + 1.5 * kRise : 0.0;
  if (asked > 0.0) {
    return std::fmax(asked, std::fmax(fastest, 2.0 * settings_.period));
  }
  const double speed = limited ? std::fmin(0.5 * limit, 2.0 * kSpeed) : kSpeed;
  return std::fmin(std::fmax(kPeak * distance / speed, kShortestGuess), kLongestGuess);
}

template <class F>
void DriveController<F>::move_joint(double time, const servo::Message& message) noexcept {
  const int coordinate = static_cast<int>(message.values[0]);
  const int iv = velocity_of(coordinate);
  if (iv < 0) {
    return;
  }
  SmoothNumber& joint = joints_[at(coordinate)];
  const bool relative = message.values[1] != 0.0;
  const double wanted = relative ? joint.target() + message.values[2]
                                 : joint.position() + way(iv, joint.position(), message.values[2]);
  const double to = std::fmin(std::fmax(wanted, settings_.lower[at(coordinate)]),
                              settings_.upper[at(coordinate)]);
  const double distance = std::fabs(to - joint.position());
  joint.move(time, to, guess_duration(distance, settings_.velocity[at(iv)], message.duration));
}

template <class F>
void DriveController<F>::go_home(double time, double duration) noexcept {
  double longest = 0.0;
  for_each_joint(
      [&](int iq, int iv) {
        const double distance =
            std::fabs(way(iv, joints_[at(iq)].position(), settings_.home[at(iq)]));
        longest =
            std::fmax(longest, guess_duration(distance, settings_.velocity[at(iv)], duration));
      },
      [](int, int, int) {});
  longest = longest > 0.0 ? longest : kShortestGuess;
  for_each_joint(
      [&](int iq, int iv) {
        const double from = joints_[at(iq)].position();
        joints_[at(iq)].move(time, from + way(iv, from, settings_.home[at(iq)]), longest);
      },
      [&](int k, int iq, int) {
        const double* home = settings_.home.data() + iq;
        const double quaternion[4] = {home[3], home[4], home[5], home[6]};
        double rotation[9];
        core::rotation_from_quaternion(quaternion, rotation);
        floating_[at(k)].move(time, {home[0], home[1], home[2]}, longest);
        floating_[at(k)].turn(time, rotation, longest);
      });
}

template <class F>
void DriveController<F>::move_pose(double time, const servo::Message& message,
                                   SmoothPose& pose) noexcept {
  const int index = static_cast<int>(message.values[0]);
  if (index >= 0) {
    set_control(time, state_, Control::task);
    free_[at(index)] = false;
  }
  double from[3];
  double to[3];
  pose.goal_position(to);
  pose.position(from);
  const bool relative = message.values[1] != 0.0;
  double squared = 0.0;
  for (int i = 0; i < 3; ++i) {
    to[i] = (relative ? to[i] : 0.0) + message.values[at(2 + i)];
    squared += (to[i] - from[i]) * (to[i] - from[i]);
  }
  const double duration = message.duration > 0.0
                              ? message.duration
                              : std::fmax(kPeak * std::sqrt(squared) / kPointSpeed, kShortestGuess);
  pose.move(time, to, duration);
}

template <class F>
void DriveController<F>::turn_pose(double time, const servo::Message& message,
                                   SmoothPose& pose) noexcept {
  const int index = static_cast<int>(message.values[0]);
  if (index >= 0) {
    set_control(time, state_, Control::task);
    free_[at(index)] = false;
  }
  double to[9];
  if (message.values[1] != 0.0) {
    const double by[3] = {message.values[2], message.values[3], message.values[4]};
    double turn[9];
    core::rotation_from_vector(by, turn);
    const double(&from)[9] = pose.goal_rotation();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        to[3 * i + j] =
            turn[3 * i] * from[j] + turn[3 * i + 1] * from[3 + j] + turn[3 * i + 2] * from[6 + j];
      }
    }
  } else {
    const double quaternion[4] = {message.values[2], message.values[3], message.values[4],
                                  message.values[5]};
    core::rotation_from_quaternion(quaternion, to);
  }
  double angles[3];
  core::orientation_error(pose.rotation(), to, angles);
  const double angle = core::square_root(core::steps::squared_norm(angles));
  const double duration = message.duration > 0.0
                              ? message.duration
                              : std::fmax(kPeak * angle / kTurnSpeed, kShortestGuess);
  pose.turn(time, to, duration);
}

template <class F>
void DriveController<F>::drag_pose(double time, const servo::Message& message,
                                   SmoothPose& pose) noexcept {
  const int index = static_cast<int>(message.values[0]);
  if (index >= 0) {
    set_control(time, state_, Control::task);
    free_[at(index)] = false;
    point_leases_[at(index)] = time + kLease;
  } else {
    floating_leases_[0] = time + kLease;
  }
  pose.follow_position({message.values[2], message.values[3], message.values[4]},
                       4.0 * kPointSpeed);
  if (message.values[1] != 0.0) {
    const double quaternion[4] = {message.values[5], message.values[6], message.values[7],
                                  message.values[8]};
    double to[9];
    core::rotation_from_quaternion(quaternion, to);
    pose.follow_rotation(to, 2.0 * kTurnSpeed);
  }
}

template <class F>
void DriveController<F>::drag_joint(double time, const servo::Message& message) noexcept {
  const int coordinate = static_cast<int>(message.values[0]);
  const int iv = velocity_of(coordinate);
  if (iv < 0) {
    return;
  }
  const double from = joints_[at(coordinate)].position();
  const double wanted = from + way(iv, from, message.values[1]);
  const double to = std::fmin(std::fmax(wanted, settings_.lower[at(coordinate)]),
                              settings_.upper[at(coordinate)]);
  const double limit = settings_.velocity[at(iv)];
  joints_[at(coordinate)].follow(to, std::isfinite(limit) ? 0.7 * limit : 2.0 * kSpeed);
  joint_leases_[at(coordinate)] = time + kLease;
}

template <class F>
void DriveController<F>::begin_pull(double time, const servo::Message& message) noexcept {
  const int link = static_cast<int>(message.values[0]);
  if (link < 0 || link >= F::kLinks) {
    return;
  }
  bool elsewhere = link != pull_link_;
  for (int i = 0; i < 3; ++i) {
    elsewhere = elsewhere || pull_on_link_[i] != message.values[at(1 + i)];
    pull_on_link_[i] = message.values[at(1 + i)];
    pull_to_[i] = message.values[at(4 + i)];
  }
  if (elsewhere || !pulled()) {
    for (int i = 0; i < 3; ++i) pull_hand_[i] = pull_to_[i];
    blend_asked_ = blend_asked_ || pulled();
  }
  pull_link_ = link;
  pull_until_ = time + kLease;
  pulled_ = true;
}

template <class F>
void DriveController<F>::set_gains(const servo::Message& message) noexcept {
  const int which = static_cast<int>(message.values[0]);
  const core::Gains<double> gains{message.values[1], message.values[2]};
  if (which != 1) {
    joint_gains_ = gains;
  }
  if (which != 0) {
    task_gains_ = gains;
  }
  blend_asked_ = true;
}

}  // namespace treeline::drive
