#include "check/step_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mode.hpp"

namespace treeline {
namespace {

using core::MessageKind;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<long double> widen(const std::vector<double>& numbers) {
  return {numbers.begin(), numbers.end()};
}

std::vector<long double> read_member(const StepNumbers& numbers, const StepMember* member) {
  if (member == nullptr) return {};
  const auto from = numbers.begin() + static_cast<std::ptrdiff_t>(member->at);
  return {from, from + static_cast<std::ptrdiff_t>(member->count)};
}

}  // namespace

StepMotion::StepMotion(const StepLibrary& library, const StepDynamics& dynamics, int index,
                       std::uint64_t seed)
    : library_(library),
      dynamics_(dynamics),
      mishap_(index % kMishaps),
      rng_((1000 * seed) + static_cast<std::uint64_t>(index)),
      robot_(dynamics.draw(index)),
      default_config_(library.default_config()),
      config_(default_config_),
      input_(library.zeros(StepPart::input)) {
  const auto of_config = [&](const char* name) {
    return read_member(config_, library.find(StepPart::config, name));
  };
  lower_ = of_config("lower");
  upper_ = of_config("upper");
  speed_ = of_config("speed");
  period_ = static_cast<double>(of_config("period").front());
  if (mishap_ == kObserves) observe();
  robot_.q = start_pose(rng_);
  robot_.qd.assign(robot_.q.size(), 0);
  std::fill(robot_.f_ext.begin(), robot_.f_ext.end(), 0.0);
}

/// Lets velocities be found from coordinates, as soon as steps can follow.
void StepMotion::observe() {
  const long double fastest = 0.45L / static_cast<long double>(period_);
  const StepMember& hold = *library_.find(StepPart::config, "hold_frequency");
  if (4 * config_[hold.at] > fastest) return;
  config_[library_.find(StepPart::config, "observer")->at] = fastest;
  default_config_ = config_;
}

/// Springs of an ordinary arm, damped by a ratio.
void StepMotion::comply() {
  const auto fill = [&](const char* name, long double value) {
    const StepMember& member = *library_.find(StepPart::config, name);
    std::fill_n(config_.begin() + static_cast<std::ptrdiff_t>(member.at), member.count, value);
  };
  fill("joint_stiffness", 20);
  fill("joint_damping_ratio", 0.7L);
  command(static_cast<int>(MessageKind::comply));
}

/// Somewhere in the middle half of the joints' ranges.
std::vector<double> StepMotion::start_pose(Rng& rng) const {
  std::vector<double> q;
  for (std::size_t i = 0; i < lower_.size(); ++i) {
    const auto low = static_cast<double>(std::max(lower_[i], -2.0L));
    const auto high = static_cast<double>(std::min(upper_[i], 2.0L));
    const double middle = (low + high) / 2;
    q.push_back(low < high ? middle + rng.within((high - low) / 4)
                           : static_cast<double>(std::clamp(0.0L, lower_[i], upper_[i])));
  }
  return q;
}

void StepMotion::set(const std::string& member, const std::vector<long double>& values) {
  const StepMember* const place = library_.find(StepPart::input, member);
  if (place == nullptr) return;
  const std::size_t count = std::min(values.size(), place->count);
  std::copy_n(values.begin(), count, input_.begin() + static_cast<std::ptrdiff_t>(place->at));
}

void StepMotion::command(int kind, double duration) {
  set("command.kind", {static_cast<long double>(kind)});
  set("command.sequence", {++sequence_});
  set("command.duration", {static_cast<long double>(duration)});
  set("command.point", {0});
  special_ = true;
  reset_ = kind == static_cast<int>(MessageKind::reset);
}

void StepMotion::move_joints(double size, double duration, MessageKind kind) {
  std::vector<long double> goal;
  for (std::size_t i = 0; i < robot_.q.size(); ++i) {
    const auto slow = 0.2 * duration * static_cast<double>(std::min(speed_[i], 100.0L));
    const auto to = static_cast<long double>(robot_.q[i] + rng_.within(std::min(size, slow)));
    goal.push_back(std::clamp(to, lower_[i], upper_[i]));
  }
  set("command.goal", goal);
  command(static_cast<int>(kind), duration);
}

/// The first point to a place nearby, turned as it is.
void StepMotion::move_point(double size, double duration) {
  if (library_.find(StepPart::input, "command.position") == nullptr) return;
  std::vector<double> poses = dynamics_.poses(robot_);
  const std::size_t points = poses.size() / 12;
  std::vector<long double> place(poses.begin(), poses.begin() + 3);
  for (long double& x : place) x += static_cast<long double>(rng_.within(size));
  const auto turned = poses.begin() + static_cast<std::ptrdiff_t>(3 * points);
  set("command.position", place);
  set("command.rotation", widen({turned, turned + 9}));
  command(static_cast<int>(MessageKind::move_point), duration);
}

void StepMotion::press() {
  if (library_.find(StepPart::input, "command.direction") == nullptr) return;
  set("command.direction", {0, 0, -1});
  set("command.force", {5});
  set("force", widen({rng_.within(2), rng_.within(2), -rng_.within(0, 4)}));
  command(static_cast<int>(MessageKind::press), 20 * period_);
}

/// The last set of tasks that the controller knows, or the first again.
void StepMotion::behave(bool first) {
  const StepMember* const shares = library_.find(StepPart::config, "behaviour_share");
  if (shares == nullptr) return;
  const std::size_t tasks = library_.find(StepPart::state, "active_tasks")->count;
  command(static_cast<int>(MessageKind::behave), 15 * period_);
  set("command.point", {static_cast<long double>(first ? 0 : (shares->count / tasks) - 1)});
}

/// Commands that have to be refused.
void StepMotion::command_nonsense(int which) {
  const auto posture = static_cast<int>(MessageKind::set_posture);
  set("command.goal", widen(robot_.q));
  if (which == 0) return command(77);
  if (which == 1) return command(posture, 1e-30);
  if (which == 2) return command(posture, kNaN);
  set("command.goal", std::vector<long double>(robot_.q.size(), kNaN));
  command(posture, 100 * period_);
}

/// `since` steps ago it began.
void StepMotion::go_wrong(int since) {
  constexpr int kEnds = 12;
  special_ = special_ || since < 3 || since == kEnds;
  std::vector<long double> q = widen(robot_.q), qd = widen(robot_.qd);
  const std::size_t joint = rng_.below(q.size());
  if (mishap_ == 0) q[joint] = kNaN;
  if (mishap_ == 1) qd[joint] = std::numeric_limits<double>::infinity();
  if (mishap_ == 2) q.assign(q.size(), kNaN), qd.assign(qd.size(), kNaN);
  if (mishap_ == 3) q[0] += 0.2L;
  if (mishap_ == 4) qd[0] *= 1000;
  set("q", q);
  set("qd", qd);
  const StepMember& torque = *library_.find(StepPart::config, "torque");
  if (mishap_ == 5) config_[torque.at] = kNaN;
  if (since == kEnds) config_ = default_config_;
}

void StepMotion::follow_script() {
  const auto kind = [](MessageKind of) { return static_cast<int>(of); };
  constexpr int kWrong = 400, kRight = 412;
  if (tick_ == 10) command(kind(MessageKind::start));
  if (tick_ == 20) move_joints(0.2, 100 * period_);
  if (tick_ == 70) move_joints(0.2, 80 * period_);
  if (tick_ == 160 || tick_ == 355) command(kind(MessageKind::reset));
  if (tick_ == 165) command(kind(MessageKind::start));
  if (tick_ >= 170 && tick_ < 174) command_nonsense(tick_ - 170);
  if (tick_ == 180) move_point(0.02, 60 * period_);
  if (tick_ == 215) behave(false);
  if (tick_ == 235) behave(true);
  if (tick_ == 250) press();
  if (tick_ == 290) move_joints(0.1, 100 * period_);
  if (tick_ == 320) command(kind(MessageKind::stop));
  if (tick_ == 360) command(kind(MessageKind::start));
  if (tick_ == 365) move_joints(0.2, 100 * period_);
  if (tick_ == 390) command(kind(MessageKind::instruction));
  if (tick_ >= kWrong && tick_ <= kRight) go_wrong(tick_ - kWrong);
  if (tick_ == 440) command(kind(MessageKind::emergency_stop));
  if (tick_ == 470) command(kind(MessageKind::reset));
  if (tick_ == 480) command(kind(MessageKind::start));
  if (tick_ == 484) comply();
  if (tick_ == 488) move_joints(0.1, 60 * period_, MessageKind::lead_posture);
}

void StepMotion::prepare() {
  ++tick_;
  special_ = reset_ = false;
  set("q", widen(robot_.q));
  set("qd", widen(robot_.qd));
  for (const auto& [quantity, values] : robot_.others) set(symbol_of(quantity), widen(values));
  follow_script();
}

void StepMotion::move(const StepNumbers& output) {
  const auto tau = read_member(output, library_.find(StepPart::output, "tau"));
  robot_.tau.assign(tau.begin(), tau.end());
  const std::vector<double> qdd = dynamics_.accelerate(robot_);
  for (std::size_t i = 0; i < qdd.size() && std::isfinite(qdd[i]); ++i) {
    // As measured: numbers of the code's own type.
    const auto rounded = [&](double x) {
      return dynamics_.unit() > 1e-10 ? static_cast<double>(static_cast<float>(x)) : x;
    };
    robot_.qd[i] = rounded(robot_.qd[i] + (period_ * qdd[i]));
    robot_.q[i] = rounded(robot_.q[i] + (period_ * robot_.qd[i]));
  }
}

void run_steps(const StepLibrary& library, StepMotion& motion,
               const std::function<void(const MadeStep&)>& show) {
  StepResult made{library.zeros(StepPart::state), library.zeros(StepPart::output)};
  const std::size_t mode = library.find(StepPart::output, "mode")->at;
  for (int step = 0; step < StepMotion::kSteps; ++step) {
    motion.prepare();
    const StepNumbers before = made.state;
    const long double mode_before = made.output[mode];
    library.step(motion.config(), made.state, motion.input(), made.output);
    const bool switches = made.output[mode] != mode_before;
    show({step, before, made, motion.is_special() || switches});
    motion.move(made.output);
  }
}

}  // namespace treeline
