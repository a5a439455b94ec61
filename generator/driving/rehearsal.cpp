#include "driving/rehearsal.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "servo/state_machine.hpp"

namespace treeline {
namespace {

constexpr std::size_t kMostMessages = 20000;  // minutes of dragging
constexpr double kOrigin = 0.05;              // s: until then the twin's loop has begun
constexpr double kAhead = 0.02;               // s from a command to its cycle

servo::Message plain_message(servo::MessageKind kind) {
  servo::Message message;
  message.kind = kind;
  return message;
}

}  // namespace

Rehearsal::Rehearsal(const drive::RobotLibrary& library, const drive::RobotDescription& robot,
                     const Begin& begin)
    : begin_(begin.q),
      period_(1 / begin.rate),
      loop_(library, robot, {begin.rate, begin.real_time, begin.q, begin.home, {}, {}, {}}),
      session_(robot, begin.rate, library.has_center_of_mass,
               [this](const servo::Message& message) { return loop_.send(message); }),
      numbers_(static_cast<std::size_t>(session_.layout().size)),
      origin_(std::ceil(kOrigin / period_) * period_) {
  loop_.step();  // control goes on from the torque that holds the twin
  loop_.send(plain_message(servo::MessageKind::start));
  for (const servo::Message& message : begin.settings) schedule(message, origin_);
  schedule(drive::make_message(drive::Instruction::begin_here), origin_);
  last_ = origin_;
  if (begin.real_time) {
    servo_ = std::thread([this] { run(); });
  } else {
    while (session_.report().head.time < origin_ + 0.5 * period_) step();
  }
}

Rehearsal::~Rehearsal() {
  ended_ = true;
  if (servo_.joinable()) servo_.join();
}

void Rehearsal::run() {
  while (!ended_ && loop_.step()) {
  }
}

void Rehearsal::schedule(const servo::Message& message, double time) {
  messages_.push_back({time - origin_, message});
  loop_.send_at(message, time);
}

bool Rehearsal::take(const servo::Message& message) {
  if (messages_.size() >= kMostMessages) return false;
  receive();
  const double time = std::ceil((std::max(twin_time(), origin_) + kAhead) / period_) * period_;
  if (!loop_.send_at(message, time)) return false;
  messages_.push_back({time - origin_, message});
  last_ = std::max(last_, time);
  return true;
}

void Rehearsal::step() {
  loop_.step();
  receive();
}

void Rehearsal::receive() {
  drive::ReportHead head;
  while (loop_.receive(head, numbers_.data())) session_.take_report(head, numbers_.data());
}

bool Rehearsal::moving() const {
  const drive::ReportHead& head = session_.report().head;
  if (head.mode == static_cast<int>(servo::Mode::faulted)) return false;
  return head.moving || twin_time() < last_ + 2 * period_;
}

}  // namespace treeline
