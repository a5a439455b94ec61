#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "drive/command.hpp"
#include "drive/parse_words.hpp"

namespace treeline::drive {
namespace {

constexpr double kLargest = 1e4;     // m, rad: nothing that is driven goes further
constexpr double kLongest = 3600.0;  // s
constexpr double kShortest = 0.02;   // s
constexpr double kStiffest = 1e5;    // 1/s^2

class Parser {
 public:
  Parser(std::string_view line, const RobotDescription& robot)
      : line_(line), words_(split_line(line)), robot_(robot) {}

  std::variant<Command, CommandFault> parse() {
    if (words_.empty()) return CommandFault{};
    if (line_.size() > kLongestCommand) {
      return CommandFault{fmt::format("a command has at most {} bytes", kLongestCommand),
                          kLongestCommand};
    }
    parse_verb();
    if (!fault_ && next_ < words_.size()) {
      fail(fmt::format("expected the end of the command{}, found `{}`",
                       next_ > 0 ? " after `" + shown_word(words_[next_ - 1].text) + "`" : "",
                       shown_word(words_[next_].text)));
    }
    if (fault_) return *fault_;
    return command_;
  }

 private:
  void parse_verb();
  void parse_goal(Verb verb);
  void parse_posture();
  void parse_move();
  void parse_turn();
  void parse_drag();
  void parse_pull();
  void parse_hold();
  void parse_mode();
  void parse_gains();
  void parse_wait();

  void fail(std::string text) {
    if (fault_) return;
    fault_ = CommandFault{std::move(text), next_ < words_.size() ? words_[next_].at : line_.size()};
  }
  /// Text of the word where something else was expected, for an error.
  std::string found() const {
    return next_ < words_.size() ? "found `" + shown_word(words_[next_].text) + "`"
                                 : std::string("the command ends");
  }
  std::string after() const {
    return next_ > 0 ? " after `" + shown_word(words_[next_ - 1].text) + "`" : std::string();
  }
  bool sees(std::string_view word) const {
    return !fault_ && next_ < words_.size() && words_[next_].text == word;
  }
  bool takes(std::string_view word) {
    const bool seen = sees(word);
    next_ += seen ? 1 : 0;
    return seen;
  }
  void expect(std::string_view word) {
    if (!takes(word)) fail(fmt::format("expected `{}`{}, {}", word, after(), found()));
  }
  std::optional<std::string_view> take_word(const char* what) {
    if (fault_) return std::nullopt;
    if (next_ == words_.size()) {
      fail(fmt::format("expected {}{}, the command ends", what, after()));
      return std::nullopt;
    }
    return words_[next_++].text;
  }

  double take_number(const char* what, double largest = kLargest) {
    if (fault_) return 0.0;
    if (next_ == words_.size()) {
      fail(fmt::format("expected a number for {}{}, the command ends", what, after()));
      return 0.0;
    }
    std::string_view text = words_[next_].text;
    if (text.size() > 1 && text[0] == '+') text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
      fail(fmt::format("expected a number for {}{}, {}", what, after(), found()));
      return 0.0;
    }
    if (std::fabs(value) > largest) {
      fail(fmt::format("{} is to lie within {:g} and {:g}, {}", what, -largest, largest, found()));
      return 0.0;
    }
    ++next_;
    return value;
  }
  void take_numbers(std::initializer_list<const char*> names) {
    for (const char* name : names) {
      const double value = take_number(name);
      command_.numbers[static_cast<std::size_t>(command_.number_count++)] = value;
    }
  }
  bool more_numbers() const {
    return !fault_ && next_ < words_.size() && words_[next_].text != "in";
  }

  void take_duration() {
    if (!takes("in")) return;
    const double seconds = take_number("the duration");
    const double scale = takes("ms") ? 1e-3 : 1.0;
    if (scale == 1.0) (void)takes("s");
    command_.duration = scale * seconds;
    if (!fault_ && (command_.duration < kShortest || command_.duration > kLongest)) {
      --next_;
      fail(fmt::format("a duration is to lie within {} and {} s", kShortest, kLongest));
    }
  }

  int take_name(const char* what, const std::vector<std::string>& names) {
    const auto word = take_word(what);
    if (!word) return 0;
    const auto found = std::find(names.begin(), names.end(), *word);
    if (found != names.end()) {
      command_.has_target = true;
      return static_cast<int>(found - names.begin());
    }
    --next_;
    fail(fmt::format("there is no {} `{}`: {}", what, shown_word(*word),
                     suggest_word(*word, names)));
    return 0;
  }
  void take_coordinate() {
    std::vector<std::string> names;
    std::vector<int> indices;
    for (std::size_t i = 0; i < robot_.coordinates.size(); ++i) {
      if (!is_single(robot_.coordinates[i])) continue;
      names.push_back(robot_.coordinates[i].name);
      indices.push_back(static_cast<int>(i));
    }
    const int which = take_name("joint", names);
    command_.target = fault_ ? 0 : indices[static_cast<std::size_t>(which)];
  }
  void take_point(bool with_base) {
    std::vector<std::string> names;
    for (const DrivenPoint& point : robot_.points) names.push_back(point.name);
    const bool base = with_base && robot_.floating &&
                      std::find(names.begin(), names.end(), "base") == names.end();
    if (base) names.emplace_back("base");
    command_.target = take_name("point", names);
    if (base && command_.target + 1 == static_cast<int>(names.size())) command_.target = kBasePoint;
  }
  void take_to_or_by() {
    if (takes("by")) {
      command_.relative = true;
    } else if (!takes("to")) {
      fail(fmt::format("expected `to` or `by`{}, {}", after(), found()));
    }
  }
  void take_position(const DrivenCoordinate& coordinate);

  std::string_view line_;
  std::vector<Word> words_;
  const RobotDescription& robot_;
  std::size_t next_ = 0;
  Command command_;
  std::optional<CommandFault> fault_;
};

/// A number and its unit, within the limits if it is absolute.
void Parser::take_position(const DrivenCoordinate& coordinate) {
  const bool angle = is_angle(coordinate);
  const std::size_t start = next_;
  double value = take_number(angle ? "the angle" : "the position");
  if (takes("deg")) {
    if (!angle) {
      --next_;
      fail(fmt::format("expected m for `{}`, which slides, found `deg`", coordinate.name));
    }
    command_.degrees = true;
    value *= angle_unit(command_);
  } else if (sees("rad") || sees("m")) {
    if (sees("rad") != angle) {
      fail(fmt::format("expected {} for `{}`, {}", angle ? "rad or deg" : "m", coordinate.name,
                       found()));
    }
    ++next_;
  }
  // Limits that are typed with the digits that people see are the limits.
  constexpr double kSlack = 1e-3;
  if (!fault_ && !command_.relative &&
      (value < coordinate.lower - kSlack || value > coordinate.upper + kSlack)) {
    next_ = start;
    const double unit = angle_unit(command_);
    fail(fmt::format("`{}` goes from {:.4g} to {:.4g} {}, not to {:.4g}", coordinate.name,
                     coordinate.lower / unit, coordinate.upper / unit,
                     angle ? angle_unit_name(command_) : "m", value / unit));
  }
  command_.numbers[0] = std::clamp(value, command_.relative ? -kLargest : coordinate.lower,
                                   command_.relative ? kLargest : coordinate.upper);
  command_.number_count = 1;
}

void Parser::parse_goal(Verb verb) {
  command_.verb = verb;
  take_coordinate();
  if (fault_) return;
  take_to_or_by();
  take_position(robot_.coordinates[static_cast<std::size_t>(command_.target)]);
  take_duration();
}

void Parser::parse_posture() {
  if (takes("home")) {
    command_.verb = Verb::home;
    take_duration();
    return;
  }
  parse_goal(Verb::posture);
}

void Parser::parse_move() {
  command_.verb = Verb::move;
  take_point(true);
  take_to_or_by();
  take_numbers({"x", "y", "z"});
  take_duration();
}

/// Checks that a quaternion has a direction, and makes its length 1.
bool normalise(double* quaternion) {
  double squared = 0.0;
  for (int i = 0; i < 4; ++i) squared += quaternion[i] * quaternion[i];
  const double length = std::sqrt(squared);
  if (!(length > 1e-6)) return false;
  for (int i = 0; i < 4; ++i) quaternion[i] /= length;
  return true;
}

void Parser::parse_turn() {
  command_.verb = Verb::turn;
  take_point(true);
  take_to_or_by();
  if (command_.relative) {
    take_numbers({"rx", "ry", "rz"});
    command_.degrees = takes("deg");
    if (!command_.degrees) (void)takes("rad");
    for (double& number : command_.numbers) number *= angle_unit(command_);
  } else {
    take_numbers({"qx", "qy", "qz", "qw"});
    if (!fault_ && !normalise(command_.numbers.data())) {
      fail("a quaternion of length 0 has no direction");
    }
  }
  take_duration();
}

void Parser::parse_drag() {
  if (takes("joint")) {
    command_.verb = Verb::drag_joint;
    take_coordinate();
    if (fault_) return;
    expect("to");
    take_position(robot_.coordinates[static_cast<std::size_t>(command_.target)]);
    return;
  }
  command_.verb = Verb::drag_point;
  take_point(true);
  expect("to");
  take_numbers({"x", "y", "z"});
  if (!more_numbers()) return;
  take_numbers({"qx", "qy", "qz", "qw"});
  if (!fault_ && !normalise(command_.numbers.data() + 3)) {
    fail("a quaternion of length 0 has no direction");
  }
}

void Parser::parse_pull() {
  command_.verb = Verb::pull;
  command_.target = take_name("link", robot_.links);
  expect("at");
  take_numbers({"x on the link", "y on the link", "z on the link"});
  expect("to");
  take_numbers({"x", "y", "z"});
}

void Parser::parse_hold() {
  command_.verb = Verb::hold;
  if (next_ < words_.size()) {
    take_point(true);
  } else {
    command_.target = -1;
  }
}

void Parser::parse_mode() {
  command_.verb = Verb::mode;
  const std::vector<std::string> controls = {"joint", "task", "gravity"};
  const auto word = take_word("`joint`, `task` or `gravity`");
  if (!word) return;
  const auto found = std::find(controls.begin(), controls.end(), *word);
  if (found == controls.end()) {
    --next_;
    fail(fmt::format("expected `joint`, `task` or `gravity` after `mode`, found `{}`",
                     shown_word(*word)));
    return;
  }
  command_.control = static_cast<Control>(found - controls.begin());
  if (command_.control == Control::task && robot_.points.empty()) {
    --next_;
    fail("this robot has no operational points: the scene lists none");
  }
}

void Parser::parse_gains() {
  command_.verb = Verb::gains;
  command_.target = takes("joint") ? 0 : takes("task") ? 1 : 2;
  expect("stiffness");
  command_.numbers[0] = take_number("the stiffness", kStiffest);
  expect("damping");
  command_.numbers[1] = take_number("the damping", kLargest);
  command_.number_count = 2;
  if (!fault_ && (command_.numbers[0] < 0.0 || command_.numbers[1] < 0.0)) {
    fail("stiffness and damping are not negative");
  }
}

void Parser::parse_wait() {
  command_.verb = Verb::wait;
  if (next_ == words_.size()) return;
  command_.duration = take_number("the seconds", kLongest);
  (void)takes("s");
  if (!fault_ && command_.duration < 0.0) fail("a duration is not negative");
}

void Parser::parse_verb() {
  struct Simple {
    const char* word;
    Verb verb;
  };
  constexpr Simple kSimple[] = {
      {"start", Verb::start}, {"stop", Verb::stop},      {"brake", Verb::brake},
      {"reset", Verb::reset}, {"take", Verb::take},      {"give", Verb::give},
      {"help", Verb::help},   {"quit", Verb::quit},      {"rehearse", Verb::rehearse},
      {"go", Verb::go},       {"discard", Verb::discard}};
  for (const Simple& simple : kSimple) {
    if (takes(simple.word)) {
      command_.verb = simple.verb;
      return;
    }
  }
  if (takes("joint")) return parse_goal(Verb::joint);
  if (takes("posture")) return parse_posture();
  if (takes("move")) return parse_move();
  if (takes("turn")) return parse_turn();
  if (takes("drag")) return parse_drag();
  if (takes("pull")) return parse_pull();
  if (takes("hold")) return parse_hold();
  if (takes("mode")) return parse_mode();
  if (takes("gains")) return parse_gains();
  if (takes("wait")) return parse_wait();
  if (takes("follow")) {
    command_.verb = Verb::follow;
    if (!robot_.has_reference) {
      --next_;
      return fail("there is no motion to follow: start with --reference FILE");
    }
    return take_duration();
  }
  if (takes("release")) {
    command_.verb = Verb::release;
    return take_point(false);
  }
  const std::vector<std::string> words = {
      "start",   "stop", "brake", "reset",   "mode",     "joint", "move",   "turn",
      "posture", "hold", "drag",  "release", "pull",     "gains", "take",   "give",
      "wait",    "help", "quit",  "follow",  "rehearse", "go",    "discard"};
  fail(fmt::format("there is no command `{}`: {}", shown_word(words_[0].text),
                   suggest_word(words_[0].text, words)));
}

}  // namespace

std::variant<Command, CommandFault> parse_command(std::string_view line,
                                                  const RobotDescription& robot) {
  return Parser(line, robot).parse();
}

}  // namespace treeline::drive
