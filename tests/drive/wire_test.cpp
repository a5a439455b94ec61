// Would catch: a message that is malformed, oversized, foreign, doubled, reordered or late and is
// obeyed or not counted; a watcher who commands; a command that is acknowledged and not sent.
#include "drive/wire.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>

#include "servo/state_machine.hpp"
#include "test_robot.hpp"

namespace treeline::drive {
namespace {

using nlohmann::json;

class WireTest : public ::testing::Test {
 protected:
  WireTest()
      : session_(test::every_kind_of_joint(), 1000, true, [this](const servo::Message& message) {
          if (full_) return false;
          sent_.push_back(message);
          return true;
        }) {
    report(servo::Mode::running);
  }

  void report(servo::Mode mode) {
    ReportHead head;
    head.mode = static_cast<int>(mode);
    const std::vector<double> numbers(static_cast<std::size_t>(session_.layout().size));
    session_.take_report(head, numbers.data());
  }
  static json command(int seq, const std::string& text) {
    return {{"type", "command"},
            {"version", 1},
            {"robot", "0123456789abcdef"},
            {"seq", seq},
            {"text", text}};
  }
  json receive(const json& message) { return receive(message.dump()); }
  json receive(const std::string& text) {
    return json::parse(inbox_.receive(text, now_, states_, session_));
  }

  std::vector<servo::Message> sent_;
  bool full_ = false;
  Session session_;
  Inbox inbox_{1, true};
  double now_ = 100.0;
  std::map<std::int64_t, double> states_ = {{41, 99.4}, {42, 99.9}};
};

TEST_F(WireTest, ObeysAndAnswers) {
  const json reply = receive(command(7, "move tool by 0 0 -0.1 in 2 s"));
  EXPECT_EQ(reply["type"], "reply");
  EXPECT_EQ(reply["seq"], 7);
  EXPECT_TRUE(reply["ok"]) << reply;
  ASSERT_EQ(sent_.size(), 1U);
  EXPECT_EQ(sent_[0].index, static_cast<int>(Instruction::move_point));
  EXPECT_EQ(sent_[0].values[4], -0.1);
  EXPECT_EQ(sent_[0].duration, 2);
}

TEST_F(WireTest, CountsWhatItDoesNotObey) {
  receive(command(7, "hold"));
  const auto refuse = [&](const json& message, std::uint64_t RefusedCounts::*count) {
    const std::uint64_t before = session_.refused().*count;
    const json reply = receive(message);
    EXPECT_FALSE(reply["ok"].get<bool>()) << message;
    EXPECT_EQ(session_.refused().*count, before + 1) << message;
  };
  refuse(command(7, "hold"), &RefusedCounts::repeated);
  refuse(command(3, "hold"), &RefusedCounts::repeated);
  json foreign = command(8, "hold");
  foreign["robot"] = "another";
  refuse(foreign, &RefusedCounts::foreign);
  for (const char* member : {"type", "version", "seq", "text"}) {
    json lacking = command(8, "hold");
    lacking.erase(member);
    refuse(lacking, &RefusedCounts::malformed);
    lacking[member] = json::array({1});
    refuse(lacking, &RefusedCounts::malformed);
  }
  json old = command(8, "hold");
  old["version"] = 0;
  refuse(old, &RefusedCounts::malformed);
  json negative = command(-1, "hold");
  refuse(negative, &RefusedCounts::malformed);
  refuse(command(8, "hold the line"), &RefusedCounts::refused);
  full_ = true;
  refuse(command(9, "hold"), &RefusedCounts::refused);
  EXPECT_EQ(sent_.size(), 1U);
}

TEST_F(WireTest, SurvivesMalformedMessages) {
  const std::string good = command(7, "hold").dump();
  std::minstd_rand random(3);
  for (int i = 0; i < 20000; ++i) {
    std::string text = good.substr(0, random() % (good.size() + 1));
    for (auto k = random() % 4; k > 0 && !text.empty(); --k) {
      text[random() % text.size()] = static_cast<char>(random() % 256);
    }
    const json reply = receive(text);
    ASSERT_TRUE(reply["ok"].is_boolean());
  }
  EXPECT_FALSE(receive(std::string(4000, '['))["ok"].get<bool>());
  EXPECT_FALSE(receive(std::string(100000, ' '))["ok"].get<bool>());
}

// A drag needs a front end that sees where the robot is.
TEST_F(WireTest, RefusesLateLeases) {
  json drag = command(1, "drag tool to 1 2 3");
  EXPECT_FALSE(receive(drag)["ok"].get<bool>());
  drag["seq"] = 2;
  drag["seen"] = 41;  // 0.6 s ago
  EXPECT_FALSE(receive(drag)["ok"].get<bool>());
  drag["seq"] = 3;
  drag["seen"] = 43;  // never sent
  EXPECT_FALSE(receive(drag)["ok"].get<bool>());
  EXPECT_EQ(session_.refused().late, 3U);
  EXPECT_TRUE(sent_.empty());
  drag["seq"] = 4;
  drag["seen"] = 42;
  EXPECT_TRUE(receive(drag)["ok"].get<bool>());
  EXPECT_EQ(sent_.size(), 1U);
}

TEST_F(WireTest, WatchersOnlyWatch) {
  Inbox watcher(2, false);
  for (const char* text : {"start", "brake", "reset", "take", "give", "hold"}) {
    static int seq = 0;
    const json reply =
        json::parse(watcher.receive(command(++seq, text).dump(), now_, states_, session_));
    EXPECT_FALSE(reply["ok"].get<bool>()) << text;
  }
  EXPECT_TRUE(sent_.empty());
  EXPECT_FALSE(session_.authority().holder());
}

// One commands, everybody may stop.
TEST_F(WireTest, OneCommandsAndAllMayStop) {
  Inbox other(2, true);
  int seq = 0;
  const auto say = [&](const char* text) {
    return json::parse(other.receive(command(++seq, text).dump(), now_, states_, session_));
  };
  EXPECT_TRUE(receive(command(1, "hold"))["ok"].get<bool>());
  EXPECT_FALSE(say("hold")["ok"].get<bool>());
  EXPECT_TRUE(say("stop")["ok"].get<bool>());
  EXPECT_EQ(sent_.back().kind, servo::MessageKind::emergency_stop);
  EXPECT_FALSE(say("take")["ok"].get<bool>());
  const auto notes = session_.take_notes();
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0].text, "front end 2, which does not command, stops the robot");
  EXPECT_EQ(notes[1].front_end, 1);
  EXPECT_TRUE(receive(command(2, "give"))["ok"].get<bool>());
  EXPECT_TRUE(say("hold")["ok"].get<bool>());
}

// What cannot be done in a mode is said before it is sent.
TEST_F(WireTest, KnowsWhatTheLoopCanDo) {
  report(servo::Mode::idle);
  EXPECT_NE(receive(command(1, "hold"))["text"].get<std::string>().find("`start` first"),
            std::string::npos);
  report(servo::Mode::faulted);
  EXPECT_NE(receive(command(2, "start"))["text"].get<std::string>().find("`reset` first"),
            std::string::npos);
  EXPECT_TRUE(sent_.empty());
  EXPECT_TRUE(receive(command(3, "reset"))["ok"].get<bool>());
  report(servo::Mode::idle);
  EXPECT_TRUE(receive(command(4, "start"))["ok"].get<bool>());
  EXPECT_TRUE(receive(command(5, "hold"))["ok"].get<bool>());  // before a report shows the start
}

TEST_F(WireTest, TellsTheStateAsJson) {
  const json hello = json::parse(print_hello(
      session_, 1000, true, {{"a.stl", "/x", "", ""}, {"b.stl", "", "it is cut", "Copy it."}}));
  EXPECT_EQ(hello["coordinates"].size(), 13U);
  EXPECT_TRUE(hello["coordinates"][9]["upper"].is_null());
  EXPECT_EQ(hello["meshes"]["a.stl"], "/mesh/0");
  EXPECT_EQ(hello["missing_meshes"]["b.stl"], "it is cut. Copy it.");
  const json watched = json::parse(
      print_hello(session_, 1000, false, {{"b.stl", "", "it is cut", "Copy it."}}, "?pass=1"));
  EXPECT_EQ(watched["missing_meshes"]["b.stl"], "") << "paths of this machine are for few";
  const json state = json::parse(finish_state(print_state(session_, 5, 1), true));
  EXPECT_EQ(state["q"].size(), 13U);
  EXPECT_EQ(state["qd"].size(), 12U);
  EXPECT_EQ(state["points"].size(), 2U);
  EXPECT_TRUE(state["commanding"].get<bool>());
  EXPECT_EQ(state["mode"], "running");
}

TEST_F(WireTest, TellsWhereTheRobotBegan) {
  const std::vector<double> numbers(static_cast<std::size_t>(session_.layout().size), 1.0);
  session_.take_report({}, numbers.data());
  EXPECT_EQ(json::parse(print_hello(session_, 1000, true, {}))["start"], std::vector<double>(13));
  const Session fresh(test::every_kind_of_joint(), 1000, true,
                      [](const servo::Message&) { return true; });
  EXPECT_TRUE(json::parse(print_hello(fresh, 1000, true, {}))["start"].is_null());
}

// Before a report could tell of the reset.
TEST_F(WireTest, StartsRightAfterAReset) {
  report(servo::Mode::faulted);
  EXPECT_FALSE(receive(command(1, "start"))["ok"].get<bool>());
  EXPECT_TRUE(receive(command(2, "reset"))["ok"].get<bool>());
  EXPECT_TRUE(receive(command(3, "start"))["ok"].get<bool>());
  EXPECT_TRUE(receive(command(4, "hold"))["ok"].get<bool>());
  EXPECT_EQ(sent_.size(), 3U);
  EXPECT_TRUE(receive(command(5, "stop"))["ok"].get<bool>());
  EXPECT_FALSE(receive(command(6, "start"))["ok"].get<bool>()) << "a stop ends what reset began";
  receive(command(7, "reset"));
  now_ += 1.0;
  EXPECT_FALSE(receive(command(8, "start"))["ok"].get<bool>()) << "the reset has changed nothing";
}

TEST_F(WireTest, WatchersMayStop) {
  Inbox watcher(2, false);
  receive(command(1, "hold"));
  sent_.clear();
  const auto stop = [&](int seq) {
    return json::parse(watcher.receive(command(seq, "stop").dump(), now_, states_, session_));
  };
  EXPECT_TRUE(stop(1)["ok"].get<bool>());
  ASSERT_EQ(sent_.size(), 1U);
  EXPECT_EQ(sent_[0].kind, servo::MessageKind::emergency_stop);
  const auto notes = session_.take_notes();
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].front_end, Note::kEverybody);
  EXPECT_EQ(notes[0].text, "front end 2, which may only watch, stops the robot");
  receive(command(2, "stop"));
  report(servo::Mode::faulted);
  EXPECT_TRUE(stop(2)["ok"].get<bool>());
  EXPECT_TRUE(session_.take_notes().empty()) << "who commands knows; then it is stopped already";
  EXPECT_EQ(session_.authority().holder(), 1);
}

// Gains of 0 that one has left behind would let the robot of the next one sink.
TEST_F(WireTest, GainsEndWithWhoChoseThem) {
  Inbox other(2, true);
  int seq = 0;
  const auto restored = [&] {
    const bool found = std::any_of(sent_.begin(), sent_.end(), [](const servo::Message& message) {
      return message.index == static_cast<int>(Instruction::set_gains) && message.values[0] == 2 &&
             message.values[1] == kStiffness && message.values[2] == kDamping;
    });
    sent_.clear();
    return found;
  };
  const auto weaken = [&] {
    const json reply = receive(command(++seq, "gains stiffness 0 damping 0"));
    EXPECT_TRUE(reply["ok"].get<bool>()) << reply;
    receive(command(++seq, "hold"));
    EXPECT_FALSE(restored()) << "they last as long as the same one commands";
  };
  weaken();
  receive(command(++seq, "reset"));
  EXPECT_TRUE(restored());
  weaken();
  receive(command(++seq, "give"));
  EXPECT_TRUE(restored());
  weaken();
  session_.leave(1, now_);
  EXPECT_TRUE(restored());
  weaken();
  now_ += 60.0;
  other.receive(command(1, "take").dump(), now_, states_, session_);
  EXPECT_TRUE(restored());
  other.receive(command(2, "hold").dump(), now_, states_, session_);
  EXPECT_FALSE(restored());
}

// A name may take all of its 16 bytes, and then ends without a 0.
TEST(OwnControllerOnTheWire, ShowsItsNumbersAndKeepsItsGains) {
  RobotDescription robot = test::every_kind_of_joint();
  robot.has_controller = true;
  int sent = 0;
  Session session(robot, 1000, true, [&sent](const servo::Message&) { return ++sent > 0; });
  ReportHead head;
  head.mode = static_cast<int>(servo::Mode::running);
  head.shown = {
      2,
      {{"power", 2.5},
       {{'s', 'i', 'x', 't', 'e', 'e', 'n', ' ', 'l', 'e', 't', 't', 'e', 'r', 's', '!'}, -1}}};
  const std::vector<double> numbers(static_cast<std::size_t>(session.layout().size));
  session.take_report(head, numbers.data());
  const json shown = json::parse(print_state(session, 1, 0))["shown"];
  EXPECT_EQ(shown, json({{"power", 2.5}, {"sixteen letters!", -1}}));
  EXPECT_EQ(json::parse(print_hello(session, 1000, true, {}))["controller"], "own");
  EXPECT_FALSE(session.obey(1, true, "gains stiffness 100 damping 20", 0).ok);
  EXPECT_EQ(sent, 0);
  EXPECT_TRUE(session.obey(1, true, "hold", 0).ok);
}

}  // namespace
}  // namespace treeline::drive
