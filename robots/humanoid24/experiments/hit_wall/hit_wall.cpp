#include "hit_wall.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/command_laws.hpp"
#include "core/contact_solver.hpp"
#include "core/ldlt.hpp"
#include "core/spline.hpp"
#include "humanoid24_wall.hpp"
#include "humanoid24_wall_joints.hpp"
#include "servo/clock.hpp"
#include "servo/integrate.hpp"
#include "servo/run_for.hpp"
#include "servo/safety.hpp"
#include "servo/spring_posture.hpp"

namespace treeline::experiments {
namespace {

namespace robot = humanoid24_wall;
constexpr int kJoints = robot::kVelocities;

struct Wall24 {
  static constexpr int kCoordinates = robot::kCoordinates;
  static constexpr int kVelocities = robot::kVelocities;
  static constexpr auto& mass_matrix = robot::mass_matrix;
  static constexpr auto& inverse_dynamics = robot::inverse_dynamics;
  static constexpr auto& forward_dynamics = robot::forward_dynamics;
};
using State = servo::StateOf<Wall24>;

constexpr double kNormal[3] = {-1, 0, 0};  // points out of the wall
constexpr double kSwingBound = 1.0;        // rad/s

struct Hand {
  double x[3] = {};
  double v[3] = {};
};

Hand hand_of(const State& state) {
  Hand hand;
  robot::contact_motion(state.q, state.qd, hand.x, hand.v);
  return hand;
}

double kinetic_energy(const State& state) {
  double M[kJoints * kJoints] = {};
  robot::mass_matrix(state.q, M);
  double energy = 0;
  for (int i = 0; i < kJoints; ++i) {
    for (int j = 0; j < kJoints; ++j) {
      energy += 0.5 * state.qd[i] * M[i * kJoints + j] * state.qd[j];
    }
  }
  return energy;
}

/// Computes F = Lambda xdd_cmd, with the inertia that is felt at the knuckles.
void commanded_force(const State& state, const double (&xdd)[3], double (&force)[3]) {
  double Lambda_inverse[9] = {};
  robot::contact_inverse_inertia(state.q, Lambda_inverse);
  std::copy(std::begin(xdd), std::end(xdd), std::begin(force));
  if (core::ldlt_factor<3>(Lambda_inverse)) {
    core::ldlt_solve<3>(Lambda_inverse, force);
  }
}

/// The robot before the wall.
class WallRobot {
 public:
  WallRobot(const State& state, const WallSettings& settings) : state_(state), settings_(settings) {
    // A pressing hand strikes in every step.
    blows_.reserve(static_cast<std::size_t>(settings.duration * settings.rate + 1) *
                   static_cast<std::size_t>(settings.substeps));
  }

  [[nodiscard]] bool connected() const noexcept { return true; }
  void read(State& state) const noexcept { state = state_; }
  void write(const double (&tau)[kJoints]) noexcept {
    std::copy(std::begin(tau), std::end(tau), std::begin(tau_));
  }
  void pass_time(double seconds) noexcept {
    impulse_ = 0;
    for (int k = 0; k < settings_.substeps; ++k) {
      impulse_ += advance(seconds / settings_.substeps);
    }
    time_ += seconds;
  }

  /// Normal impulse on the robot in the last `pass_time`, N s.
  [[nodiscard]] double impulse() const noexcept { return impulse_; }
  [[nodiscard]] double deepest() const noexcept { return deepest_; }
  [[nodiscard]] const std::vector<WallBlow>& blows() const noexcept { return blows_; }

 private:
  /// Advances time by `dt`. In the air by Runge-Kutta; at the wall velocities first, then the blow,
  /// then coordinates, so that a pressing hand does not sink in. Returns the normal impulse on the
  /// robot.
  double advance(double dt) noexcept {
    const double distance = settings_.wall - hand_of(state_).x[0];
    deepest_ = std::max(deepest_, -distance);
    if (distance > 0) {
      servo::integrate_runge_kutta<Wall24>({}, tau_, dt, state_);
      return 0;
    }
    double qdd[kJoints];
    robot::forward_dynamics(state_.q, state_.qd, tau_, qdd);
    for (int i = 0; i < kJoints; ++i) {
      state_.qd[i] += dt * qdd[i];
    }
    const double impulse = strike();
    for (int i = 0; i < kJoints; ++i) {
      state_.q[i] += dt * state_.qd[i];
    }
    return impulse;
  }

  double strike() noexcept {
    double A[9];
    robot::contact_inverse_inertia(state_.q, A);
    core::ContactLaw<double> law;
    std::copy(std::begin(kNormal), std::end(kNormal), std::begin(law.normal));
    law.friction = settings_.friction;
    const Hand hand = hand_of(state_);
    WallBlow blow;
    blow.time = time_;
    blow.approach = hand.v[0];
    if (blow.approach <= 0) {
      return 0;
    }
    blow.restitution = blow.approach < settings_.slow ? 0 : settings_.restitution;
    law.restitution = blow.restitution;
    double y[3] = {};
    double v[3];
    std::copy(std::begin(hand.v), std::end(hand.v), std::begin(v));
    solver_.solve(1, A, &law, v, y);
    for (int i = 0; i < 3; ++i) {
      blow.work += 0.5 * y[i] * (hand.v[i] + v[i]);
    }
    blow.energy = -kinetic_energy(state_);
    double dqd[kJoints];
    robot::impulse_response(state_.q, y, dqd);
    for (int i = 0; i < kJoints; ++i) {
      state_.qd[i] += dqd[i];
    }
    blow.energy += kinetic_energy(state_);
    double mass[1];
    robot::effective_mass(state_.q, kNormal, mass);
    blow.mass = mass[0];
    blow.parting = -hand_of(state_).v[0];
    blow.impulse = -y[0];
    blows_.push_back(blow);
    return blow.impulse;
  }

  core::ContactSolver<double, 1> solver_;
  State state_;
  WallSettings settings_;
  double tau_[kJoints] = {};
  double time_ = 0;
  double impulse_ = 0;
  double deepest_ = 0;
  std::vector<WallBlow> blows_;
};

servo::SpringPosture<Wall24> springs_of(const Plan& plan, double rate) {
  return {{plan.spring, 1.0, plan.limit_margin, plan.limit_strength, 1.0 / rate},
          robot::kLowerLimits,
          robot::kUpperLimits};
}

/// Control torque of Chang table 6.1: the hand follows a spline to the goal behind the wall,
/// springs draw the posture to the initial one.
class WallController {
 public:
  WallController(const Plan& plan, const WallSettings& settings, const State& start)
      : settings_(settings), posture_(springs_of(plan, settings.rate)), start_(start) {
    const Hand hand = hand_of(start);
    const double goal[3] = {settings.wall + settings.behind, hand.x[1], hand.x[2]};
    spline_ = core::rest_to_rest<3>(hand.x, goal, settings.reach_time);
  }

  /// Commanded acceleration of the hand at the last call of `control`, m/s^2.
  [[nodiscard]] const double (&commanded() const noexcept)[3] { return xdd_; }

  void start(double, const State&) noexcept {}
  void apply(double, const servo::Message&) noexcept {}
  void control(double time, const State& state, double (&tau)[kJoints]) noexcept {
    const Hand hand = hand_of(state);
    const auto wanted = spline_.at(time);
    double error[3];
    for (int i = 0; i < 3; ++i) {
      error[i] = wanted.position[i] - hand.x[i];
    }
    core::tracking_law<3, double>({settings_.stiffness, settings_.damping}, error, hand.v,
                                  wanted.velocity, wanted.acceleration, xdd_);
    double qdd_0[kJoints];
    posture_.advise(state, start_.q, qdd_0);
    robot::control_torque(state.q, state.qd, qdd_0, xdd_, tau);
  }

 private:
  WallSettings settings_;
  servo::SpringPosture<Wall24> posture_;
  State start_;
  core::CubicSegment<3, double> spline_;
  double xdd_[3] = {};
};

/// Appends a cycle; `force` is the mean over the cycle before.
void record(const servo::Report<Wall24>& report, const Plan& plan, const WallSettings& settings,
            double force, report::Table& table) {
  const Hand hand = hand_of(report.state);
  const auto rate = [&](const char* name) {
    const auto found = std::find(plan.joints.begin(), plan.joints.end(), name);
    return report.state.qd[found - plan.joints.begin()];
  };
  std::vector<double> row = {report.time,
                             hand.x[0],
                             hand.x[1],
                             hand.x[2],
                             settings.wall - hand.x[0],
                             hand.v[0],
                             force,
                             kinetic_energy(report.state),
                             rate("left_shoulder_pitch"),
                             rate("left_elbow"),
                             rate("hip"),
                             rate("ankle")};
  row.insert(row.end(), std::begin(report.state.q), std::end(report.state.q));
  table.append(row.data());
}

std::vector<std::string> column_names() {
  std::vector<std::string> names = {"time",
                                    "x",
                                    "y",
                                    "z",
                                    "distance",
                                    "speed_into_wall",
                                    "force",
                                    "kinetic_energy",
                                    "shoulder_pitch_rate",
                                    "elbow_rate",
                                    "hip_rate",
                                    "ankle_rate"};
  for (const char* joint : robot::kCoordinateJoints) {
    names.push_back(std::string("q_") + joint);
  }
  return names;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) {
    value *= factor;
  }
  return values;
}

}  // namespace

WallRun run_hit_wall(const Plan& plan, const WallSettings& settings) {
  State state;
  std::copy(plan.start.begin(), plan.start.end(), std::begin(state.q));
  WallRobot before_wall(state, settings);
  WallController controller(plan, settings, state);
  servo::SimulatedClock clock;
  servo::Mailbox mailbox;
  servo::LoopSettings loop;
  loop.rate = settings.rate;
  const auto rows = static_cast<std::size_t>(settings.duration * settings.rate) + 2;
  WallRun run{report::Table(column_names(), rows), {}, {}, 0, 0, 0, 0};
  constexpr double kEnd = 0.2;  // s at the end over which forces are averaged
  const double share = 1 / std::floor(kEnd * settings.rate);
  const servo::RunEnd end = servo::run_for<Wall24>(
      settings.duration, loop,
      servo::limits_of(robot::kLowerLimits, robot::kUpperLimits, robot::kVelocityLimits,
                       robot::kEffortLimits),
      before_wall, controller, clock, mailbox, [&](const servo::Report<Wall24>& report) {
        const double force = before_wall.impulse() * settings.rate;
        record(report, plan, settings, force, run.table);
        for (const double rate : report.state.qd) {
          if (before_wall.blows().empty()) run.swing = std::max(run.swing, std::abs(rate));
        }
        if (report.time > settings.duration - kEnd + 0.5 / settings.rate) {
          double wanted[3];
          commanded_force(report.state, controller.commanded(), wanted);
          run.pressing += share * force;
          run.commanded += share * wanted[0];
        }
      });
  run.fault = end.fault;
  run.blows = before_wall.blows();
  run.deepest = before_wall.deepest();
  return run;
}

std::string hit_wall_summary(const WallRun& run, const WallSettings& settings) {
  if (run.blows.empty()) {
    return "the hand never reached the wall\n";
  }
  const WallBlow& first = run.blows.front();
  std::string text = fmt::format(
      "reach        joints turn at up to {:.3f} rad/s (bound {})\n"
      "first blow   at {:.4f} s: {:.4f} m/s into the wall, {:.4f} m/s out of it (e = {})\n"
      "             effective mass {:.4f} kg, impulse {:.4f} N s\n"
      "             energy {:+.6f} J by the velocities, {:+.6f} J by the impulse",
      run.swing, kSwingBound, first.time, first.approach, first.parting, settings.restitution,
      first.mass, first.impulse, first.energy, first.work);
  if (settings.friction == 0) {
    const double e = settings.restitution;
    text += fmt::format(", {:+.6f} J by restitution",
                        -0.5 * (1 - e * e) * first.mass * first.approach * first.approach);
  }
  return text +
         fmt::format(
             "\nblows        {}; deepest in the wall {:.1e} m\n"
             "at rest      presses with {:.3f} N, commanded {:.3f} N\n",
             run.blows.size(), run.deepest, run.pressing, run.commanded) +
         (run.fault ? "stopped      " + servo::describe(run.fault) + "\n" : "");
}

report::Plot hit_wall_figure(const WallRun& run) {
  const report::Table& table = run.table;
  report::Plot plot;
  plot.title = "The humanoid's left fist hits a wall and presses against it (Chang chapter 8)";
  plot.x_label = "time (s)";
  plot.x = table.column(0);
  plot.panels.push_back({"Distance of the knuckles from the wall",
                         "distance (mm)",
                         {{"", scaled(table.column(4), 1e3), false}},
                         0.1});
  plot.panels.push_back({"Speed into the wall", "speed (m/s)", {{"", table.column(5), false}}, 0});
  plot.panels.push_back({"Force on the wall, mean over each millisecond",
                         "force (N)",
                         {{"", table.column(6), false}},
                         0});
  plot.panels.push_back({"Joint rates: the blow goes through the whole body",
                         "rate (rad/s)",
                         {{"left shoulder pitch", table.column(8), false},
                          {"left elbow", table.column(9), false},
                          {"hip", table.column(10), false},
                          {"ankle", table.column(11), false}},
                         0});
  return plot;
}

bool hit_wall_claims_hold(const WallRun& run, const WallSettings& settings) {
  if (run.blows.empty()) {
    return false;
  }
  const WallBlow& first = run.blows.front();
  bool hold = !run.fault && first.approach > 0.1 && run.swing < kSwingBound &&
              std::abs(first.parting - settings.restitution * first.approach) < 1e-9;
  for (const WallBlow& blow : run.blows) {
    hold = hold && std::abs(blow.energy - blow.work) < 1e-9;
    if (settings.friction == 0) {
      const double e = blow.restitution;
      const double lost = 0.5 * (1 - e * e) * blow.mass * blow.approach * blow.approach;
      hold = hold && std::abs(blow.energy + lost) < 1e-9;
    }
  }
  return hold && run.deepest < 1e-3 &&
         std::abs(run.pressing - run.commanded) < 0.02 * std::abs(run.commanded);
}

}  // namespace treeline::experiments
