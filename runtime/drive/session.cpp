#include "drive/session.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "servo/safety.hpp"
#include "servo/state_machine.hpp"

namespace treeline::drive {

Session::Session(const RobotDescription& robot, double rate, bool has_center_of_mass,
                 std::function<bool(const servo::Message&)> send)
    : robot_(robot),
      layout_(report_layout(static_cast<int>(robot.coordinates.size()), robot.velocities,
                            static_cast<int>(robot.points.size()))),
      has_center_of_mass_(has_center_of_mass),
      send_(std::move(send)),
      timing_(rate) {
  report_.numbers.resize(static_cast<std::size_t>(layout_.size));
}

void Session::take_report(const ReportHead& head, const double* numbers) {
  report_.head = head;
  std::copy_n(numbers, layout_.size, report_.numbers.begin());
  const double* q = numbers + layout_.q;
  if (start_.empty()) start_.assign(q, q + robot_.coordinates.size());
  timing_.take(head);
}

std::vector<Note> Session::take_notes() {
  return std::exchange(notes_, {});
}

std::string Session::fault() const {
  const ReportHead& head = report_.head;
  if (head.fault_kind == 0) return {};
  const servo::Fault fault{static_cast<servo::FaultKind>(head.fault_kind), head.fault_index,
                           head.fault_value, head.fault_limit};
  std::string name;
  const bool of_position = fault.kind == servo::FaultKind::position_limit;
  for (std::size_t i = 0; i < robot_.coordinates.size(); ++i) {
    const DrivenCoordinate& coordinate = robot_.coordinates[i];
    const int index = of_position ? static_cast<int>(i) : coordinate.velocity_index;
    if (index == fault.index && index >= 0) name = coordinate.name;
  }
  return servo::describe(fault, name);
}

Answer Session::refuse(std::string text, int at) {
  ++refused_.refused;
  return {false, std::move(text), at};
}

Answer Session::hand_over(int front_end, Verb verb, double now) {
  const auto holder = authority_.holder();
  if (verb == Verb::give) {
    if (!authority_.give(front_end, now)) return refuse("this front end does not command");
    if (const auto next = authority_.holder()) {
      notes_.push_back({*next, "the command was handed over: this front end commands"});
    }
    return {true, "the command is given up", -1};
  }
  if (authority_.take(front_end, now)) {
    if (holder && *holder != front_end) {
      notes_.push_back({*holder, "another front end has taken the command after a long silence"});
    }
    return {true, "this front end commands", -1};
  }
  notes_.push_back({*holder, "another front end asks for the command: `give` hands it over"});
  return refuse("another front end commands and has been asked to `give`");
}

void Session::tell_holder(const std::string& text) {
  if (const auto holder = authority_.holder()) notes_.push_back({*holder, text});
}

/// Gains are of the one who chose them: whoever commands next, or after a reset, begins anew.
void Session::restore_gains() {
  if (!gains_from_) return;
  constexpr double kBoth = 2;
  servo::Message gains = make_message(Instruction::set_gains);
  gains.values = {kBoth, kStiffness, kDamping};
  if (send_(gains)) gains_from_.reset();
}

void Session::leave(int front_end, double now) {
  authority_.leave(front_end, now);
  if (gains_from_ == front_end) restore_gains();
}

void Session::note_sent(const Command& command, double now) {
  const Verb verb = command.verb;
  const bool goes_on = verb == Verb::start || needs_running(verb);
  started_ = verb == Verb::start ? now : goes_on ? started_ : -1.0;
  reset_ = verb == Verb::reset ? now : goes_on ? reset_ : -1.0;
  if (verb == Verb::reset) restore_gains();
  if (verb == Verb::gains) gains_from_ = authority_.holder();
}

Answer Session::send(const Command& command, double now) {
  if (rehearsing_.divert) {
    if (const auto taken = rehearsing_.divert(command.verb, message_for(command))) {
      if (!*taken) return refuse("the rehearsal is full: `go` or `discard`");
      return {true, "rehearsed: " + describe(command, robot_), -1};
    }
  }
  if (!send_(message_for(command))) {
    return refuse("too many commands at once: the loop's mailbox is full");
  }
  note_sent(command, now);
  return {true, describe(command, robot_), -1};
}

namespace {

constexpr double kUntilReported = 0.05;  // s

}  // namespace

bool Session::is_faulted(double now) const {
  return static_cast<servo::Mode>(report_.head.mode) == servo::Mode::faulted &&
         (reset_ < 0.0 || now - reset_ >= kUntilReported);
}

bool Session::runs(double now) const {
  return static_cast<servo::Mode>(report_.head.mode) == servo::Mode::running ||
         (started_ >= 0.0 && now - started_ < kUntilReported);
}

void Session::tell_of_stop(int front_end, bool may_command) {
  const bool stopped = static_cast<servo::Mode>(report_.head.mode) == servo::Mode::faulted;
  if (stopped || authority_.holder() == front_end) return;
  notes_.push_back(
      {Note::kEverybody, fmt::format("front end {}, which {}, stops the robot", front_end,
                                     may_command ? "does not command" : "may only watch")});
}

Answer Session::obey(int front_end, bool may_command, std::string_view line, double now) {
  const auto parsed = parse_command(line, robot_);
  if (const auto* fault = std::get_if<CommandFault>(&parsed)) {
    if (fault->text.empty()) return refuse("there is no command in this line");
    return refuse(fault->text, static_cast<int>(fault->at));
  }
  return obey(front_end, may_command, std::get<Command>(parsed), now);
}

Answer Session::obey(int front_end, bool may_command, const Command& command, double now) {
  if (is_local(command.verb)) return refuse("this command is for scripts and standard input");
  if (command.verb == Verb::stop) {
    tell_of_stop(front_end, may_command);
    return send(command, now);
  }
  if (!may_command) {
    return refuse("this front end may only watch and `stop`: its address lacks the token");
  }
  if (command.verb == Verb::take || command.verb == Verb::give) {
    Answer answer = hand_over(front_end, command.verb, now);
    if (authority_.holder() != gains_from_) restore_gains();
    return answer;
  }
  if (needs_authority(command.verb) && !authority_.obeys(front_end, now)) {
    return refuse("another front end commands: `take` asks for it");
  }
  if (robot_.has_controller && command.verb == Verb::gains) {
    return refuse("the robot's own controller has its gains");
  }
  if (authority_.holder() != gains_from_) restore_gains();
  const auto mode = static_cast<servo::Mode>(report_.head.mode);
  if (is_faulted(now) && (needs_running(command.verb) || command.verb == Verb::start)) {
    return refuse(fmt::format("the robot is faulted ({}): `reset` first", fault()));
  }
  if (!runs(now) && needs_running(command.verb)) {
    return refuse(fmt::format("the robot is {}: `start` first", servo::mode_name(mode)));
  }
  if (is_of_rehearsal(command.verb)) {
    if (!rehearsing_.obey) return refuse("there are no rehearsals here");
    Answer answer = rehearsing_.obey(command.verb);
    refused_.refused += answer.ok ? 0 : 1;
    if (answer.ok && command.verb == Verb::go) gains_from_ = front_end;  // it may bring gains
    return answer;
  }
  return send(command, now);
}

}  // namespace treeline::drive
