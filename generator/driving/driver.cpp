#include "driving/driver.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include "drive/machine_time.hpp"
#include "drive/rate_limit.hpp"
#include "drive/script.hpp"
#include "drive/server.hpp"
#include "drive/session.hpp"
#include "drive/udp_robot.hpp"
#include "driving/find_start.hpp"
#include "driving/loop_handle.hpp"
#include "driving/page_server.hpp"
#include "driving/rehearsals.hpp"
#include "driving/robot_elsewhere.hpp"
#include "interruption/clean_up.hpp"
#include "servo/realtime.hpp"
#include "servo/safety.hpp"
#include "servo/state_machine.hpp"
#include "terminal/write_output.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

using namespace std::chrono_literals;
using drive::machine_time;
using drive::Verb;

std::atomic<bool> asked_to_end{false};

double unix_milliseconds() {
  using Milliseconds = std::chrono::duration<double, std::milli>;
  return Milliseconds(std::chrono::system_clock::now().time_since_epoch()).count();
}

void say(const std::string& line) {
  print_message(printable(line) + "\n");
}

std::string print_usages() {
  std::string text;
  for (const drive::CommandUsage& usage : drive::command_usages()) {
    text += fmt::format("  {:<46} {}\n", usage.usage, usage.does);
  }
  return text;
}

/// A run of the loop with its front ends.
class Driver {
 public:
  Driver(const LaunchedRobot& robot, const DriveSettings& settings,
         const std::vector<double>& start, const drive::ExternalRobot& external)
      : settings_(settings),
        loop_(robot.library.functions(), robot.description,
              {settings.rate,
               settings.real_time,
               start,
               {},
               settings.simulation.options(),
               external,
               settings.reference.motion()}),
        session_(robot.description, settings.rate, robot.library.functions().has_center_of_mass,
                 [this](const servo::Message& message) {
                   rehearsals_.note_sent(message);
                   return loop_.send(message);
                 }),
        rehearsals_(robot.library.functions(), session_, loop_, settings.rate, settings.real_time,
                    start),
        numbers_(static_cast<std::size_t>(session_.layout().size)),
        local_(session_.join()),
        record_(settings.record) {
    if (settings.script) script_.append(*settings.script);
    if (!settings.reads_input) script_.close();
    if (settings.has_controller) return;  // a twin would have another one
    session_.set_rehearsing({[this](Verb verb) { return rehearsals_.obey(verb); },
                             [this](Verb verb, const servo::Message& message) {
                               return rehearsals_.divert(verb, message);
                             }});
  }

  bool has_loop(Diagnostics& diagnostics) const;
  bool open_record(Diagnostics& diagnostics);
  bool open_server(Diagnostics& diagnostics);
  DriveOutcome run();

 private:
  void run_as_fast_as_possible();
  void run_in_real_time();
  void attend();
  void tell(const drive::Note& note);
  void tell_front_ends();
  drive::ServerHandlers handlers();
  void receive();
  void obey_script();
  void obey_line(const drive::Script::Line& line);
  void obey_local(const drive::Command& command);
  void read_input();
  void record_state();
  void end();
  void watch_end();
  double now() const { return settings_.real_time ? machine_time() : time(); }
  double time() const { return session_.report().head.time; }
  bool moving() const { return session_.report().head.moving || rehearsals_.moving(); }

  const DriveSettings& settings_;
  LoopHandle loop_;
  drive::Session session_;
  Rehearsals rehearsals_;
  std::vector<double> numbers_;
  int local_;
  drive::Script script_;
  RecordWriter record_;
  std::int64_t state_number_ = 0;
  bool input_open_ = true;
  bool ending_ = false;
  bool awaited_ = false;  ///< nobody has seen the page yet that a script is for
  DriveOutcome outcome_;
  std::string fault_seen_;
  std::mutex mutex_;  ///< of the session, between this thread and the server's
  std::map<int, std::pair<drive::Inbox, drive::RateLimit>> inboxes_;
  std::map<std::int64_t, double> sent_;  ///< when states of the last seconds were sent
  double told_ = 0;
  std::unique_ptr<drive::Server> server_;
};

bool Driver::has_loop(Diagnostics& diagnostics) const {
  if (loop_) return true;
  diagnostics.add({Severity::error, "", 0, "--gear-stiffness",
                   "the gears swing too fast to be simulated at this rate",
                   "Give softer teeth, heavier rotors, or a higher --rate."});
  return false;
}

bool Driver::open_record(Diagnostics& diagnostics) {
  return record_.open(drive::print_hello(session_, settings_.rate, true, settings_.meshes),
                      diagnostics);
}

void Driver::record_state() {
  if (!record_.wants_state(time())) return;
  record_.write(
      drive::print_state(session_, state_number_++, 0, drive::Detail::plain, rehearsals_.twin()),
      time());
}

void Driver::receive() {
  drive::ReportHead head;
  while (loop_.receive(head, numbers_.data())) {
    session_.take_report(head, numbers_.data());
    record_state();
  }
  rehearsals_.attend([this](const std::string& text) {
    say(text);
    if (session_.authority().holder() != local_) session_.tell_holder(text);
  });
  const std::string fault = session_.fault();
  if (fault != fault_seen_ && !fault.empty()) say("fault: " + fault);
  fault_seen_ = fault;
}

void Driver::end() {
  if (ending_) return;
  ending_ = loop_.send(servo::message_of(servo::MessageKind::disconnect));
}

void Driver::obey_local(const drive::Command& command) {
  if (command.verb == Verb::wait) script_.wait(time(), command.duration);
  if (command.verb == Verb::help) print_message(print_usages());
  if (command.verb == Verb::quit) end();
}

void Driver::obey_line(const drive::Script::Line& line) {
  const auto parsed = drive::parse_command(line.text, session_.robot());
  if (const auto* command = std::get_if<drive::Command>(&parsed)) {
    if (is_local(command->verb)) return obey_local(*command);
  }
  const drive::Answer answer = session_.obey(local_, true, line.text, now());
  record_.write(drive::print_command(line.text, time(), answer), time());
  say(fmt::format("{:9.3f} s  {}{}", time(), answer.ok ? "" : fmt::format("line {}: ", line.number),
                  answer.text));
  if (answer.ok || settings_.reads_input) return;
  outcome_.script_failed = true;
  script_ = drive::Script();
  script_.close();
}

/// Obeys the script. With a page, it begins when somebody who may command looks at the page.
void Driver::obey_script() {
  awaited_ = awaited_ && server_->commanders() == 0;
  if (awaited_) return;
  drive::Script::Line line;
  while (!ending_ && script_.next(time(), moving(), line)) obey_line(line);
}

/// Takes what people have typed, as far as there is room for it: others wait meanwhile. Its end
/// ends the drive if nobody else can command.
void Driver::read_input() {
  if (!settings_.reads_input || !input_open_ || script_.is_full()) return;
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (poll(&input, 1, 0) <= 0) return;
  char bytes[512];
  const ssize_t count = read(STDIN_FILENO, bytes, sizeof(bytes));
  if (count > 0) return script_.append({bytes, static_cast<std::size_t>(count)});
  input_open_ = false;
  script_.close();
}

/// The drive ends with the script unless browsers may go on, and with a fault under a script that
/// is no `stop` of its own before other lines. A signal before the last line cuts the script.
void Driver::watch_end() {
  const auto& head = session_.report().head;
  const bool faulted = head.mode == static_cast<int>(servo::Mode::faulted);
  const bool stopped = head.fault_kind == static_cast<int>(servo::FaultKind::emergency_stop);
  const bool more = script_.has_more(time(), moving());
  if (faulted && !(stopped && more) && settings_.script && !settings_.serves &&
      outcome_.fault.empty()) {
    outcome_.fault = session_.fault();
    if (more) say("the rest of the script is not obeyed");
  }
  const bool done = !settings_.serves && script_.ended(time(), moving());
  if (asked_to_end && more) outcome_.script_cut = true;
  if (asked_to_end || done || !outcome_.fault.empty()) end();
}

void Driver::run_as_fast_as_possible() {
  while (loop_.step()) {
    rehearsals_.step();
    receive();
    if (ending_) continue;
    read_input();
    obey_script();
    watch_end();
  }
}

/// One look after everything but the loop, which runs in a thread of its own.
void Driver::attend() {
  const std::lock_guard lock(mutex_);
  receive();
  if (!ending_) {
    read_input();
    obey_script();
    watch_end();
  }
  tell_front_ends();
}

void Driver::tell(const drive::Note& note) {
  const bool for_all = note.front_end == drive::Note::kEverybody;
  if (for_all || note.front_end == local_) say(note.text);
  for (const auto& [front_end, inbox] : inboxes_) {
    if (!for_all && front_end != note.front_end) continue;
    server_->send(front_end, drive::print_note(note.text));
  }
}

/// States 30 times a second, and notes.
void Driver::tell_front_ends() {
  constexpr double kInterval = 1.0 / 30.0;  // s
  constexpr double kKept = 5.0;             // s
  for (const drive::Note& note : session_.take_notes()) tell(note);
  if (!server_ || now() < told_ + kInterval) return;
  told_ = now();
  sent_[++state_number_] = told_;
  while (sent_.begin()->second < told_ - kKept) sent_.erase(sent_.begin());
  const std::string state = drive::print_state(session_, state_number_, server_->connections(),
                                               drive::Detail::histograms, rehearsals_.twin());
  const std::optional<int> holder = session_.authority().holder();
  server_->send_states(
      [state, holder](int front_end) { return drive::finish_state(state, holder == front_end); });
}

/// Functions that the server's thread calls.
drive::ServerHandlers Driver::handlers() {
  drive::ServerHandlers handlers;
  handlers.join = [this](const drive::NewFrontEnd& joined, std::string& hello) {
    const std::lock_guard lock(mutex_);
    const int front_end = session_.join();
    inboxes_.emplace(front_end, std::pair{drive::Inbox(front_end, joined.may_command),
                                          drive::rate_for(joined.may_command)});
    hello = drive::print_hello(session_, settings_.rate, joined.may_command, settings_.meshes,
                               joined.mesh_query);
    return front_end;
  };
  handlers.receive = [this](int front_end, std::string_view message) -> std::string {
    const std::lock_guard lock(mutex_);
    auto& [inbox, limit] = inboxes_.at(front_end);
    if (!limit.admits(now())) {
      ++session_.refused().excess;
      return {};
    }
    return drive::stamp_reply(inbox.receive(message, now(), sent_, session_), unix_milliseconds());
  };
  handlers.leave = [this](int front_end) {
    const std::lock_guard lock(mutex_);
    inboxes_.erase(front_end);
    session_.leave(front_end, now());
  };
  return handlers;
}

bool Driver::open_server(Diagnostics& diagnostics) {
  if (!settings_.serves) return true;
  server_ = serve_page({settings_.listen, settings_.port, session_.robot().urdf, settings_.meshes},
                       handlers(), diagnostics);
  awaited_ = server_ != nullptr && settings_.script.has_value();
  if (awaited_) say("the script begins when the page is opened with its token");
  return server_ != nullptr;
}

void Driver::run_in_real_time() {
  std::atomic<bool> ended{false};
  std::atomic<bool> ready{false};
  std::string refused;
  std::thread servo([&] {
    refused = servo::request_realtime();
    ready = true;
    while (loop_.step()) {
    }
    ended = true;
  });
  servo::request_attention();  // it shares the lock of the session with the server's thread
  while (!ready) std::this_thread::sleep_for(1ms);
  if (!refused.empty()) say("real time: " + refused);
  while (!ended) {
    attend();
    std::this_thread::sleep_for(4ms);
  }
  servo.join();
  server_.reset();
}

DriveOutcome Driver::run() {
  if (settings_.real_time) {
    run_in_real_time();
  } else {
    run_as_fast_as_possible();
  }
  receive();
  if (session_.report().head.mode == static_cast<int>(servo::Mode::faulted)) {
    outcome_.fault = session_.fault();
  }
  outcome_.record_failed = !record_.close(time());
  outcome_.state = drive::print_state(session_, state_number_, 0);
  return outcome_;
}

/// Joints whose forces are cut cannot hold the robot, with the limits that its URDF states.
void warn_of_weight(const LaunchedRobot& robot, const std::vector<double>& start) {
  const std::string joints = describe_overload(robot.library.functions(), robot.description, start);
  if (joints.empty()) return;
  say(
      fmt::format("warning: the robot cannot hold its weight here and will sink: {}; --q chooses "
                  "another place, an effort of 0 in the URDF sets no limit",
                  joints));
}

}  // namespace

std::optional<DriveOutcome> run_drive(const LaunchedRobot& robot, const DriveSettings& settings,
                                      Diagnostics& diagnostics) {
  std::vector<double> start;
  std::unique_ptr<drive::UdpRobot> external;
  if (settings.udp_robot.empty()) {
    start = start_of(robot, settings.start, diagnostics);
    if (start.empty()) return std::nullopt;
  } else {
    external = find_robot(
        robot, {settings.udp_robot, settings.robot_secret, settings.has_controller}, diagnostics);
    if (!external) return std::nullopt;
    const auto q = external->state().begin();
    start.assign(q, q + robot.library.functions().coordinates);
  }
  if (!settings.has_controller) warn_of_weight(robot, start);
  asked_to_end = false;
  outlast_others();
  answer_signals([] { asked_to_end = true; });
  Driver driver(robot, settings, start, external ? external->functions() : drive::ExternalRobot{});
  std::optional<DriveOutcome> outcome;
  if (driver.has_loop(diagnostics) && driver.open_record(diagnostics) &&
      driver.open_server(diagnostics)) {
    outcome = driver.run();
  }
  answer_signals(nullptr);
  return outcome;
}

}  // namespace treeline
