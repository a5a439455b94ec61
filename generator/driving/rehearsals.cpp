#include "driving/rehearsals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "servo/state_machine.hpp"

namespace treeline {
namespace {

using drive::Verb;

/// rad or m: a robot at rest that the loop holds stays within it.
constexpr double kSamePlace = 5e-3;

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::fabs(a[i] - b[i]));
  return largest;
}

drive::Answer refuse(std::string text) {
  return {false, std::move(text), -1};
}

std::vector<double> q_of(const drive::Session& session) {
  const auto& numbers = session.report().numbers;
  const auto first = numbers.begin() + session.layout().q;
  return {first, first + static_cast<std::ptrdiff_t>(session.robot().coordinates.size())};
}

}  // namespace

Rehearsals::Rehearsals(const drive::RobotLibrary& library, const drive::Session& session,
                       LoopHandle& loop, double rate, bool real_time,
                       const std::vector<double>& start)
    : library_(library),
      session_(session),
      loop_(loop),
      rate_(rate),
      real_time_(real_time),
      home_(start) {}

std::vector<double> Rehearsals::robot_q() const {
  return q_of(session_);
}

std::vector<double> Rehearsals::twin_q() const {
  return q_of(rehearsal_->twin());
}

drive::Answer Rehearsals::begin() {
  if (session_.report().head.moving || going_) {
    return refuse("the robot moves: `wait` or `hold` before a rehearsal");
  }
  Rehearsal::Begin begin;
  begin.q = robot_q();
  begin.home = home_;
  begin.rate = rate_;
  begin.real_time = real_time_;
  for (const auto& gains : gains_) {
    if (gains) begin.settings.push_back(*gains);
  }
  servo::Message control = drive::make_message(drive::Instruction::set_control);
  control.values[0] = session_.report().head.control;
  begin.settings.push_back(control);
  rehearsal_.reset();
  rehearsal_ = std::make_unique<Rehearsal>(library_, session_.robot(), begin);
  return {true, "rehearsal: motions are for the twin until `go` or `discard`", -1};
}

drive::Answer Rehearsals::go() {
  if (!rehearsal_ || going_) return refuse("nothing was rehearsed: `rehearse` first");
  if (rehearsal_->moving()) return refuse("the twin has not ended its motion: `wait`");
  const std::string fault = rehearsal_->twin().fault();
  if (!fault.empty()) {
    return refuse(fmt::format("the twin ended in a fault ({}): `rehearse` again", fault));
  }
  const double off = largest_difference(robot_q(), rehearsal_->begin());
  if (session_.report().head.moving || off > kSamePlace) {
    return refuse(fmt::format(
        "the robot is not where the rehearsal began, by {:.2g} rad or m: `rehearse` again", off));
  }
  constexpr double kUntilFirst = 0.05;  // s until the loop takes the first message
  const double now = session_.report().head.time + kUntilFirst;
  const double begin = std::ceil(now * rate_) / rate_;
  pending_.clear();
  for (const TimedMessage& timed : rehearsal_->messages()) {
    pending_.push_back({begin + timed.time, timed.message});
  }
  gone_ = pending_.back().time;
  going_ = true;
  return {true,
          fmt::format("the robot does what was rehearsed, for {:.4g} s and what the last "
                      "motion takes",
                      gone_ - begin),
          -1};
}

drive::Answer Rehearsals::obey(Verb verb) {
  if (verb == Verb::rehearse) return begin();
  if (verb == Verb::go) return go();
  if (!rehearsal_ || going_) return refuse("there is no rehearsal");
  rehearsal_.reset();
  return {true, "the rehearsal is forgotten", -1};
}

std::optional<bool> Rehearsals::divert(Verb verb, const servo::Message& message) {
  if (!rehearsal_ || going_ || !drive::is_rehearsed(verb)) return std::nullopt;
  return rehearsal_->take(message);
}

void Rehearsals::note_sent(const servo::Message& message) {
  const bool is_instruction = message.kind == servo::MessageKind::instruction;
  if (is_instruction && message.index == static_cast<int>(drive::Instruction::set_gains)) {
    const auto which = static_cast<std::size_t>(message.values[0]);
    if (which == 2) gains_[0] = gains_[1] = std::nullopt;
    gains_[which] = message;
  }
  pending_.clear();
  if (going_ || !is_instruction) rehearsal_.reset();
  going_ = false;
}

void Rehearsals::attend(const std::function<void(const std::string&)>& tell) {
  if (rehearsal_ && !going_) rehearsal_->receive();
  while (!pending_.empty() && loop_.send_at(pending_.front().message, pending_.front().time)) {
    pending_.pop_front();
  }
  if (!going_) return;
  const drive::ReportHead& head = session_.report().head;
  if (head.mode != static_cast<int>(servo::Mode::running)) {
    tell("what was rehearsed is interrupted");
  } else if (head.time < gone_ + 0.4 || head.moving) {
    return;
  } else {
    tell(
        fmt::format("the robot has done what was rehearsed: it stands within {:.2g} rad or m of "
                    "its twin",
                    largest_difference(robot_q(), twin_q())));
  }
  pending_.clear();
  going_ = false;
  rehearsal_.reset();
}

void Rehearsals::step() {
  if (rehearsal_ && !going_) rehearsal_->step();
}

bool Rehearsals::moving() const {
  return going_ || (rehearsal_ && rehearsal_->moving());
}

const drive::Session* Rehearsals::twin() const {
  return rehearsal_ ? &rehearsal_->twin() : nullptr;
}

}  // namespace treeline
