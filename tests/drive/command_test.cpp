// Would catch: a command that moves something else than it says, in another unit or beyond the
// limits; an error that does not say what was expected; a line of any bytes that is obeyed in part.
#include "drive/command.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "test_robot.hpp"

namespace treeline::drive {
namespace {

const RobotDescription kRobot = test::every_kind_of_joint();

Command parsed(const std::string& line) {
  const auto result = parse_command(line, kRobot);
  const auto* fault = std::get_if<CommandFault>(&result);
  EXPECT_EQ(fault, nullptr) << line << ": " << (fault != nullptr ? fault->text : "");
  return fault != nullptr ? Command{} : std::get<Command>(result);
}

CommandFault refused(const std::string& line) {
  const auto result = parse_command(line, kRobot);
  const auto* fault = std::get_if<CommandFault>(&result);
  EXPECT_NE(fault, nullptr) << line << " is accepted";
  return fault != nullptr ? *fault : CommandFault{};
}

TEST(Command, TakesUnitsAndDurations) {
  const Command elbow = parsed("joint elbow to 45 deg in 2 s");
  EXPECT_EQ(elbow.verb, Verb::joint);
  EXPECT_EQ(kRobot.coordinates[static_cast<std::size_t>(elbow.target)].name, "elbow");
  EXPECT_NEAR(elbow.numbers[0], std::numbers::pi / 4, 1e-15);
  EXPECT_EQ(elbow.duration, 2);
  EXPECT_FALSE(elbow.relative);
  EXPECT_EQ(parsed("joint elbow by -0.5").numbers[0], -0.5);
  EXPECT_EQ(parsed("joint slider to +0.25 m in 500 ms").duration, 0.5);
  EXPECT_EQ(parsed("  joint\twheel to 1e2 # turns").numbers[0], 100);
  EXPECT_EQ(parsed("posture table.theta to 90 deg").verb, Verb::posture);
}

TEST(Command, NamesPointsAndTheBase) {
  const Command move = parsed("move camera by 0 0 -0.1 in 2 s");
  EXPECT_EQ(move.target, 1);
  EXPECT_TRUE(move.relative);
  EXPECT_EQ(move.numbers[2], -0.1);
  EXPECT_EQ(parsed("move base to 1 2 3").target, kBasePoint);
  EXPECT_EQ(parsed("turn tool by 0 0 90 deg").numbers[2], std::numbers::pi / 2);
  EXPECT_FALSE(parsed("hold").has_target);
  EXPECT_EQ(parsed("hold camera").target, 1);
  EXPECT_EQ(parsed("pull head at 0 0 0.1 to 1 1 1").target, 1);
}

TEST(Command, AnswersInTheUnitOfTheCommand) {
  const auto answer = [](const std::string& line) { return describe(parsed(line), kRobot); };
  EXPECT_EQ(answer("joint elbow to 45 deg in 2 s"), "elbow moves to 45 deg in 2 s");
  EXPECT_EQ(answer("joint elbow by -0.5"), "elbow moves by -0.5 rad");
  EXPECT_EQ(answer("drag joint slider to 0.25"), "slider follows to 0.25 m");
  EXPECT_EQ(answer("turn tool by 0 0 90 deg"), "tool turns by (0, 0, 90) deg");
  EXPECT_EQ(answer("turn tool by 0 0 1"), "tool turns by (0, 0, 1) rad");
  EXPECT_NE(refused("joint elbow to 90 deg").text.find("goes from -57.3 to 57.3 deg, not to 90"),
            std::string::npos);
}

// A quaternion is a direction: of any length but 0.
TEST(Command, MakesQuaternionsUnit) {
  const Command turn = parsed("turn tool to 0 0 3 4");
  EXPECT_NEAR(turn.numbers[2], 0.6, 1e-15);
  EXPECT_NEAR(turn.numbers[3], 0.8, 1e-15);
  EXPECT_NE(refused("turn tool to 0 0 0 0").text.find("length 0"), std::string::npos);
  const Command drag = parsed("drag tool to 1 2 3 0 0 0 2");
  EXPECT_EQ(drag.number_count, 7);
  EXPECT_EQ(drag.numbers[6], 1);
}

TEST(Command, SaysWhatWasExpectedAndWhere) {
  const auto expect = [](const std::string& line, const std::string& words, std::size_t at) {
    const CommandFault fault = refused(line);
    EXPECT_NE(fault.text.find(words), std::string::npos) << line << ": " << fault.text;
    EXPECT_EQ(fault.at, at) << line << ": " << fault.text;
  };
  expect("joint elbo to 1", "did you mean `elbow`?", 6);
  expect("jiont elbow to 1", "did you mean `joint`?", 0);
  expect("joint elbow 1", "expected `to` or `by` after `elbow`, found `1`", 12);
  expect("joint elbow to", "expected a number for the angle after `to`, the command ends", 14);
  expect("joint elbow to 1 m", "expected rad or deg", 17);
  expect("joint slider to 10 deg", "which slides", 19);
  expect("joint elbow to 2", "goes from -1 to 1 rad", 15);
  expect("joint base.x to 2", "there is no joint `base.x`", 6);
  expect("move tool by 0 0.1 up", "expected a number for z after `0.1`, found `up`", 19);
  expect("move tool by 0 0 1 in", "the duration", 21);
  expect("move tool by 0 0 1 in 0", "a duration is to lie within", 22);
  expect("start now", "expected the end of the command after `start`, found `now`", 6);
  expect("mode taks", "`joint`, `task` or `gravity`", 5);
  expect("move tool by nan 0 0", "expected a number for x", 13);
  expect("move tool by 1e5 0 0", "within -10000 and 10000", 13);
  expect("gains stiffness -1 damping 2", "not negative", 28);
  EXPECT_TRUE(refused("   # nothing").text.empty());
}

// Whatever the limits, an accepted absolute goal lies within them.
TEST(Command, KeepsGoalsWithinLimits) {
  EXPECT_EQ(parsed("joint elbow to 1.0005").numbers[0], 1.0);
  EXPECT_NE(refused("joint elbow to 57.5 deg").text.find("goes from"), std::string::npos);
  EXPECT_EQ(parsed("joint elbow to 57.3 deg").numbers[0], 1.0);
}

// Random words of the language in any order, and random bytes: the parser accepts or says why, and
// what it accepts is finite and names what exists.
TEST(Command, SurvivesEverything) {
  const std::vector<std::string> words = {
      "start", "stop",  "joint", "elbow", "to",   "by",   "1",     "-0.5", "deg",  "in",
      "2",     "s",     "move",  "tool",  "base", "turn", "drag",  "0",    "pull", "hand",
      "at",    "gains", "task",  "hold",  "wait", "mode", "1e999", "nan",  "#",    "posture"};
  std::minstd_rand random(7);
  int accepted = 0;
  for (int i = 0; i < 200000; ++i) {
    std::string line;
    const auto count = random() % 12;
    for (auto k = 0UL; k < count; ++k) {
      line += words[random() % words.size()] + (random() % 8 == 0 ? "\t" : " ");
    }
    for (auto k = random() % 3; k > 0 && !line.empty(); --k) {
      line[random() % line.size()] = static_cast<char>(random() % 256);
    }
    const auto result = parse_command(line, kRobot);
    if (const auto* fault = std::get_if<CommandFault>(&result)) {
      ASSERT_LE(fault->at, line.size());
      for (const char c : fault->text) ASSERT_TRUE(c >= ' ' && c <= '~') << fault->text;
      continue;
    }
    ++accepted;
    const Command& command = std::get<Command>(result);
    for (const double number : command.numbers) ASSERT_TRUE(std::isfinite(number)) << line;
    ASSERT_GE(command.duration, 0) << line;
    (void)describe(command, kRobot);
    (void)message_for(command);
  }
  EXPECT_GT(accepted, 1000);
  EXPECT_NE(refused(std::string(5000, 'x')).text.find("at most 400 bytes"), std::string::npos);
}

// Each line of help begins with a command that is known.
TEST(Command, ExplainsWhatItKnows) {
  for (const CommandUsage& usage : command_usages()) {
    const std::string line = usage.usage;
    const auto result = parse_command(line.substr(0, line.find(' ')), kRobot);
    const auto* fault = std::get_if<CommandFault>(&result);
    if (fault == nullptr) continue;
    EXPECT_EQ(fault->text.find("there is no command"), std::string::npos) << line;
  }
}

// Rehearsals are for motions; a stop is always the robot's. A motion is followed where there is
// one.
TEST(Command, KnowsWhatIsRehearsed) {
  EXPECT_TRUE(is_of_rehearsal(parsed("rehearse").verb));
  EXPECT_TRUE(is_of_rehearsal(parsed("go").verb));
  EXPECT_TRUE(is_of_rehearsal(parsed("discard").verb));
  for (const char* line : {"joint elbow to 0", "drag tool to 0 0 0", "mode gravity", "hold",
                           "gains stiffness 100 damping 20"}) {
    EXPECT_TRUE(is_rehearsed(parsed(line).verb)) << line;
  }
  for (const char* line : {"stop", "brake", "start", "reset", "take", "go", "rehearse"}) {
    EXPECT_FALSE(is_rehearsed(parsed(line).verb)) << line;
  }
  EXPECT_NE(refused("follow").text.find("--reference"), std::string::npos);
  RobotDescription robot = kRobot;
  robot.has_reference = true;
  const auto follow = parse_command("follow in 2 s", robot);
  ASSERT_TRUE(std::holds_alternative<Command>(follow));
  EXPECT_EQ(std::get<Command>(follow).duration, 2);
}

// A joint without a motor has no goal.
TEST(Command, LeavesPassiveJointsAlone) {
  RobotDescription robot = kRobot;
  for (DrivenCoordinate& coordinate : robot.coordinates) {
    coordinate.passive = coordinate.name == "wheel";
  }
  EXPECT_TRUE(std::holds_alternative<CommandFault>(parse_command("joint wheel to 1", robot)));
}

}  // namespace
}  // namespace treeline::drive
