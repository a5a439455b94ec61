#pragma once

// How `ImperfectRobot` moves and what its sensors see; included by its header.

namespace treeline::drive {

template <class F>
void ImperfectRobot<F>::find_coordinates() noexcept {
  int iq = 0;
  int iv = 0;
  for (int k = 0; k <= nq - nv; ++k) {
    const int end = k < nq - nv ? floating_[static_cast<std::size_t>(k)] : nq;
    for (; iq < end; ++iq, ++iv) joints_[static_cast<std::size_t>(iv)].coordinate = iq;
    iq += 7;
    iv += 6;
  }
}

template <class F>
void ImperfectRobot<F>::take_options(const SimulationOptions& options) noexcept {
  const auto entry = [](const double* list, int i) { return list != nullptr ? list[i] : 0.0; };
  for (int i = 0; i < nv; ++i) {
    Joint& joint = joints_[static_cast<std::size_t>(i)];
    if (joint.coordinate < 0) continue;
    joint.friction = {entry(options.coulomb, i), entry(options.viscous, i), kSlipSpeed};
    joint.noise = entry(options.noise, i);
    joint.quantum = entry(options.quantum, i);
    has_sensors_ = has_sensors_ || joint.noise > 0.0 || joint.quantum > 0.0;
    if (entry(options.play, i) > 0.0) {
      joint.rotor = entry(options.rotor, i);
      const double stiffness = entry(options.gear_stiffness, i);
      joint.gear = {entry(options.play, i), stiffness, 0.2 * std::sqrt(stiffness * joint.rotor)};
      has_gears_ = true;
    }
  }
  delay_ = options.delay < 0 ? 0 : options.delay > kLongestDelay ? kLongestDelay : options.delay;
}

template <class F>
void ImperfectRobot<F>::take_surroundings(const Surroundings& surroundings) noexcept {
  if constexpr (F::kLinks > 0) {
    for (int i = 0; i < surroundings.obstacle_count && i < kMostObstacles; ++i) {
      obstacles_[static_cast<std::size_t>(obstacle_count_++)] = surroundings.obstacles[i];
    }
    for (int i = 0; i < surroundings.guarded_count && i < kMostGuardedPoints; ++i) {
      guarded_[static_cast<std::size_t>(guarded_count_++)] = surroundings.guarded[i];
    }
  }
}

/// The classical Runge-Kutta method is stable up to |lambda| dt of about 2.8; a third of it is
/// asked for. The frequency of a gear is that of its stiffness between rotor and joint.
template <class F>
bool ImperfectRobot<F>::can_follow_gears(double seconds) noexcept {
  constexpr double kLargestPhase = 0.9;
  constexpr double kMostSubsteps = 200.0;
  double fastest = 0.0;
  double base[nv];
  const double none[nv] = {};
  F::forward_dynamics(links_.q, links_.qd, none, base);
  for (int i = 0; i < nv; ++i) {
    const Joint& joint = joints_[static_cast<std::size_t>(i)];
    if (!(joint.rotor > 0.0)) continue;
    double unit[nv] = {};
    unit[i] = 1.0;
    double moved[nv];
    F::forward_dynamics(links_.q, links_.qd, unit, moved);
    const double mobility = 1.0 / joint.rotor + (moved[i] - base[i]);
    fastest = std::fmax(fastest,
                        std::sqrt(joint.gear.stiffness * mobility) + joint.gear.damping * mobility);
  }
  const double needed = std::ceil(seconds * fastest / kLargestPhase);
  if (!(needed <= kMostSubsteps)) return false;
  substeps_ = needed > substeps_ ? static_cast<int>(needed) : substeps_;
  return true;
}

/// State that encoders without fault see.
template <class F>
servo::StateOf<F> ImperfectRobot<F>::seen() const noexcept {
  State state = links_;
  for (int i = 0; has_gears_ && i < nv; ++i) {
    const Joint& joint = joints_[static_cast<std::size_t>(i)];
    if (!(joint.rotor > 0.0)) continue;
    state.q[joint.coordinate] = motors_.q[joint.coordinate];
    state.qd[i] = motors_.qd[i];
  }
  return state;
}

template <class F>
void ImperfectRobot<F>::measure(double seconds) noexcept {
  const State before = measured_;
  measured_ = seen();
  const double share = seconds / (kFilter + seconds);
  for (int i = 0; i < nv; ++i) {
    const Joint& joint = joints_[static_cast<std::size_t>(i)];
    if (!(joint.noise > 0.0 || joint.quantum > 0.0)) continue;
    double& q = measured_.q[joint.coordinate];
    if (joint.noise > 0.0) q += joint.noise * noise_.next();
    if (joint.quantum > 0.0) q = joint.quantum * std::round(q / joint.quantum);
    const double difference = (q - before.q[joint.coordinate]) / seconds;
    measured_.qd[i] = before.qd[i] + share * (difference - before.qd[i]);
  }
}

/// Computes the forces of the obstacles on guarded points.
template <class F>
void ImperfectRobot<F>::feel(const State& links) noexcept {
  double none[nv] = {};
  add_contacts(links, none);
}

template <class F>
void ImperfectRobot<F>::add_contacts(const State& links, double (&tau)[nv]) noexcept {
  if (obstacle_count_ == 0 || guarded_count_ == 0) return;
  link_forces_.place(links.q);
  for (int k = 0; k < guarded_count_; ++k) {
    const GuardedPoint& point = guarded_[static_cast<std::size_t>(k)];
    double(&force)[3] = forces_[static_cast<std::size_t>(k)].f;
    double place[3];
    link_forces_.place_of(point.link, point.on_link, place);
    for (double& component : force) component = 0.0;
    for (int o = 0; o < obstacle_count_; ++o) {
      double away[3];
      const double distance = distance_to(obstacles_[static_cast<std::size_t>(o)], place, away);
      if (distance >= 0.0) continue;
      double along[nv] = {};
      link_forces_.joint_forces(links.q, point.link, place, away, along);
      double speed = 0.0;
      for (int i = 0; i < nv; ++i) speed += along[i] * links.qd[i];
      const double size = std::fmax(0.0, -kWallStiffness * distance - kWallDamping * speed);
      for (int i = 0; i < nv; ++i) tau[i] += size * along[i];
      for (int i = 0; i < 3; ++i) force[i] += size * away[i];
    }
  }
}

template <class F>
void ImperfectRobot<F>::accelerations(const State& links, const State& motors,
                                      double (&of_links)[nv], double (&of_motors)[nv]) noexcept {
  double torques[nv];
  for (int i = 0; i < nv; ++i) {
    const Joint& joint = joints_[static_cast<std::size_t>(i)];
    of_motors[i] = 0.0;
    if (joint.rotor > 0.0) {
      const int iq = joint.coordinate;
      const double passed =
          servo::gear_torque(joint.gear, motors.q[iq] - links.q[iq], motors.qd[i] - links.qd[i]);
      of_motors[i] =
          (tau_[i] - servo::friction_torque(joint.friction, motors.qd[i]) - passed) / joint.rotor;
      torques[i] = passed;
    } else {
      torques[i] = tau_[i] - servo::friction_torque(joint.friction, links.qd[i]);
    }
  }
  add_contacts(links, torques);
  const auto moved = [&](const double(&tau)[nv], double(&qdd)[nv]) {
    places_.forward_dynamics(links.q, links.qd, tau, qdd);
  };
  moved(torques, of_links);
  stops_.push(links.q, links.qd, moved, torques, of_links);
}

/// One step of the classical fourth-order Runge-Kutta method. Where teeth meet or a point touches
/// within it, the order is lost, but steps are small.
template <class F>
void ImperfectRobot<F>::integrate(double dt) noexcept {
  constexpr double kFractions[4] = {0.0, 0.5, 0.5, 1.0};
  constexpr double kWeights[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
  double rates[nq] = {};
  double motor_rates[nq] = {};
  double of_links[nv] = {};
  double of_motors[nv] = {};
  State sum = links_;
  State motor_sum = motors_;
  const auto move = [](State& state, double step, const double(&qd)[nq], const double(&qdd)[nv]) {
    for (int i = 0; i < nq; ++i) state.q[i] += step * qd[i];
    for (int i = 0; i < nv; ++i) state.qd[i] += step * qdd[i];
  };
  for (int stage = 0; stage < 4; ++stage) {
    State at = links_;
    State motor_at = motors_;
    move(at, kFractions[stage] * dt, rates, of_links);
    servo::coordinate_rates<nq, nv>(floating_, at.q, at.qd, rates);
    if (has_gears_) {
      move(motor_at, kFractions[stage] * dt, motor_rates, of_motors);
      for (int i = 0; i < nv; ++i) {
        const int iq = joints_[static_cast<std::size_t>(i)].coordinate;
        if (iq >= 0) motor_rates[iq] = motor_at.qd[i];
      }
    }
    accelerations(at, motor_at, of_links, of_motors);
    move(sum, kWeights[stage] * dt, rates, of_links);
    if (has_gears_) move(motor_sum, kWeights[stage] * dt, motor_rates, of_motors);
  }
  servo::normalise_quaternions<nq, nv>(floating_, sum.q);
  accept(sum, motor_sum);
}

/// Cuts the torque to what the feet bear. Motors of a robot that lies are short-circuited: they
/// drag with their largest torque at 200 rad/s or m/s.
template <class F>
void ImperfectRobot<F>::stand(double (&tau)[nv]) const noexcept {
  constexpr double kShorted = 0.005;  // s/rad or s/m
  if (!has_fallen()) feet_.keep(links_.q, links_.qd, tau);
  for (int i = 0; i < nv; ++i) {
    const double limit = limit_[i];
    if (has_fallen()) tau[i] = limit < kUnlimited ? -kShorted * limit * links_.qd[i] : 0.0;
    tau[i] = std::clamp(tau[i], -limit, limit);
  }
}

template <class F>
void ImperfectRobot<F>::step_on_ground(double dt) noexcept {
  double torques[nv];
  for (int i = 0; i < nv; ++i) {
    const Joint& joint = joints_[static_cast<std::size_t>(i)];
    const bool has_motor = joint.coordinate >= 0;
    torques[i] = has_motor ? tau_[i] - servo::friction_torque(joint.friction, links_.qd[i]) : 0.0;
    torques[i] += on_ground_.push[i];
  }
  add_contacts(links_, torques);
  // Stops push as strongly as they would in flight: what stands on the ground is harder to move.
  const auto fly = [&](const double(&tau)[nv], double(&qdd)[nv]) {
    F::flight_dynamics(links_.q, links_.qd, tau, qdd);
  };
  double qdd[nv];
  fly(torques, qdd);
  stops_.push(links_.q, links_.qd, fly, torques, qdd);
  State next = links_;
  F::ground_step(dt, torques, next.q, next.qd, on_ground_.memory, on_ground_.report);
  on_ground_.dt = dt;
  accept(next, motors_);
}

/// Takes the state at the end of a step if it is one.
template <class F>
void ImperfectRobot<F>::accept(const State& links, const State& motors) noexcept {
  constexpr double kFastest = 1000.0;  // rad/s or m/s
  const auto is_motion = [](const State& state) {
    double sum = 0.0;  // not finite if one is not: finite numbers times 0 are 0
    bool slow = true;
    for (const double q : state.q) sum += 0.0 * q;
    for (const double qd : state.qd) slow = slow && std::fabs(qd) <= kFastest;
    return sum == 0.0 && slow;
  };
  lost_ = !is_motion(links) || (has_gears_ && !is_motion(motors));
  broken_ = broken_ || lost_;
  if (lost_) {
    for (int i = 0; i < nv; ++i) links_.qd[i] = motors_.qd[i] = 0.0;
    return;
  }
  links_ = links;
  motors_ = motors;
  stops_.follow(links_.q);
}

}  // namespace treeline::drive
