#include "try_drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "../drive/test_robot.hpp"
#include "drive/wire.hpp"
#include "show/packet.h"

namespace treeline::fuzz {
namespace {

const drive::RobotDescription& robot() {
  static const drive::RobotDescription kRobot = test::every_kind_of_joint();
  return kRobot;
}

std::string judge_command(const drive::Command& command) {
  for (const double number : command.numbers) {
    if (!std::isfinite(number)) return "a number is not finite";
  }
  const bool of_joint = command.verb == drive::Verb::joint ||
                        command.verb == drive::Verb::posture ||
                        command.verb == drive::Verb::drag_joint;
  if (of_joint) {
    const auto& joint = robot().coordinates.at(static_cast<std::size_t>(command.target));
    if (!drive::is_single(joint)) return "a coordinate of a floating joint is a goal";
    const double goal = command.numbers[0];
    if (!command.relative && (goal < joint.lower || goal > joint.upper)) {
      return "a goal is beyond the joint's limits";
    }
  }
  if (command.duration < 0.0 || command.duration > 3600.0) return "a duration is out of range";
  (void)drive::describe(command, robot());
  (void)drive::message_for(command);
  return {};
}

std::string try_line(const std::string& text) {
  const auto parsed = drive::parse_command(text, robot());
  if (const auto* command = std::get_if<drive::Command>(&parsed)) return judge_command(*command);
  const auto& fault = std::get<drive::CommandFault>(parsed);
  if (fault.at > text.size()) return "a fault lies behind the end";
  const bool plain = std::all_of(fault.text.begin(), fault.text.end(),
                                 [](char c) { return c >= ' ' && c <= '~'; });
  return plain ? std::string() : "an answer has bytes that do something to a terminal";
}

std::string try_message(const std::string& text) {
  int sent = 0;
  drive::Session session(robot(), 1000, false, [&sent](const servo::Message& message) {
    ++sent;
    return std::all_of(message.values.begin(), message.values.end(),
                       [](double x) { return std::isfinite(x); });
  });
  drive::Inbox inbox(1, true);
  const std::string reply = inbox.receive(text, 1.0, {{1, 0.9}}, session);
  if (reply.empty() || reply.find('\n') != std::string::npos) return "a reply is no line";
  const bool ok = reply.find("\"ok\":true") != std::string::npos;
  const bool hand_over = session.authority().holder() && sent == 0;
  return !ok && sent > 0 && session.refused().refused == 0 ? "a refused message is sent"
         : ok && sent == 0 && !hand_over                   ? "an accepted message is not sent"
                                                           : "";
}

std::string try_packet(const std::string& text) {
  TreelinePacketHead head;
  std::array<double, 3> numbers{};
  (void)treeline_packet_read(reinterpret_cast<const unsigned char*>(text.data()), text.size(),
                             numbers.size(), &head, numbers.data());
  return {};
}

}  // namespace

std::string try_drive(const std::string& text) {
  std::string fault = try_line(text);
  if (fault.empty()) fault = try_message(text);
  return fault.empty() ? try_packet(text) : fault;
}

std::string mutate_drive(std::string text, Random& random) {
  constexpr std::array<std::string_view, 32> kWords = {
      "start", "stop",      "joint",   "elbow",     "slider", "to",
      "by",    "in",        "s",       "deg",       "rad",    "move",
      "tool",  "base",      "turn",    "drag",      "pull",   "hand",
      "at",    "gains",     "damping", "stiffness", "hold",   "mode",
      "1e308", "-0",        "nan",     "1e-320",    "0.5",    "\"seq\":1e300,",
      "#",     "{\"type\":"};
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ' ') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  const std::size_t at = random() % words.size();
  switch (random() % 5) {
    case 0:
      words[at] = kWords[random() % kWords.size()];
      break;
    case 1:
      words.insert(words.begin() + static_cast<std::ptrdiff_t>(at),
                   std::string(kWords[random() % kWords.size()]));
      break;
    case 2:
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 3:
      std::swap(words[at], words[random() % words.size()]);
      break;
    default:
      if (!words[at].empty()) {
        words[at][random() % words[at].size()] = static_cast<char>(random() % 256);
      }
  }
  std::string joined;
  for (const std::string& word : words) joined += (joined.empty() ? "" : " ") + word;
  return joined;
}

}  // namespace treeline::fuzz
