#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drive/authority.hpp"
#include "drive/command.hpp"
#include "drive/report.hpp"
#include "drive/robot_description.hpp"

namespace treeline::drive {

/// Answer to a line of the command language.
struct Answer {
  bool ok = false;
  std::string text;
  int at = -1;  ///< byte of the line where the fault is; -1: nowhere in the line
};

/// Told without being asked.
struct Note {
  static constexpr int kEverybody = 0;
  int front_end = kEverybody;
  std::string text;
};

/// How many messages were not obeyed, by reason.
struct RefusedCounts {
  std::uint64_t malformed = 0;  ///< no message, or of another version
  std::uint64_t foreign = 0;    ///< for another robot
  std::uint64_t repeated = 0;   ///< doubled or reordered
  std::uint64_t late = 0;       ///< a drag or a pull of a front end that sees an old state
  std::uint64_t excess = 0;     ///< beyond the rate
  std::uint64_t refused = 0;    ///< understood, but not possible or not permitted
};

/// Front ends on one side, the loop's mailbox and reports on the other. Not for several threads at
/// once. Times are in s of any clock that does not go back.
class Session {
 public:
  /// `send` leaves a message in the loop's mailbox and returns false if that is full.
  Session(const RobotDescription& robot, double rate, bool has_center_of_mass,
          std::function<bool(const servo::Message&)> send);

  /// Obeys one line of a front end, or says why not. `may_command`: it came with the token, or from
  /// this machine's own standard input; without, `stop` alone is obeyed.
  Answer obey(int front_end, bool may_command, std::string_view line, double now);
  /// Obeys a command that was understood, or says why not.
  Answer obey(int front_end, bool may_command, const Command& command, double now);

  /// Who obeys `rehearse`, `go` and `discard`, and who takes a motion in the robot's place: nothing
  /// if it is the robot's, false if it cannot be taken.
  struct Rehearsing {
    std::function<Answer(Verb)> obey;
    std::function<std::optional<bool>(Verb, const servo::Message&)> divert;
  };
  void set_rehearsing(Rehearsing rehearsing) { rehearsing_ = std::move(rehearsing); }
  /// Leaves a note for whoever commands, and for nobody else.
  void tell_holder(const std::string& text);

  int join() { return ++last_front_end_; }
  void leave(int front_end, double now);
  /// Notes since the last call.
  std::vector<Note> take_notes();

  void take_report(const ReportHead& head, const double* numbers);
  const LoopReport& report() const { return report_; }
  /// q of the first report; empty before.
  const std::vector<double>& start() const { return start_; }
  const LoopTiming& timing() const { return timing_; }
  const RobotDescription& robot() const { return robot_; }
  const ReportLayout& layout() const { return layout_; }
  const Authority& authority() const { return authority_; }
  bool has_center_of_mass() const { return has_center_of_mass_; }
  RefusedCounts& refused() { return refused_; }
  const RefusedCounts& refused() const { return refused_; }
  /// The fault of the loop in words, with the name of the joint; empty if there is none.
  std::string fault() const;

 private:
  Answer refuse(std::string text, int at = -1);
  Answer hand_over(int front_end, Verb verb, double now);
  Answer send(const Command& command, double now);
  void note_sent(const Command& command, double now);
  bool runs(double now) const;
  bool is_faulted(double now) const;
  void tell_of_stop(int front_end, bool may_command);
  void restore_gains();

  RobotDescription robot_;
  ReportLayout layout_;
  bool has_center_of_mass_;
  std::function<bool(const servo::Message&)> send_;
  Authority authority_;
  LoopReport report_;
  std::vector<double> start_;
  LoopTiming timing_;
  RefusedCounts refused_;
  std::vector<Note> notes_;
  Rehearsing rehearsing_;
  int last_front_end_ = 0;
  // When `start` and `reset` were sent; the next reports do not show it yet.
  double started_ = -1.0;
  double reset_ = -1.0;
  std::optional<int> gains_from_;  ///< the front end that has changed the gains
};

}  // namespace treeline::drive
