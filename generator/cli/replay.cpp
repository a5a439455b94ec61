#include "cli/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <vector>

#include "interruption/clean_up.hpp"

namespace treeline {
namespace {

using Json = nlohmann::ordered_json;
using namespace std::chrono_literals;

std::atomic<bool> asked_to_close{false};

/// What a file of `--record` holds.
struct Record {
  Json hello;
  std::vector<double> times;        ///< of states, s, growing
  std::vector<std::string> states;  ///< as they were written
};

/// Takes one line. False: it is no line of a record.
bool take_line(const std::string& line, Record& record) {
  Json json = Json::parse(line, nullptr, false);
  const std::string type = json.is_object() ? json.value("type", "") : "";
  if (type == "hello" && record.hello.is_null()) {
    record.hello = std::move(json);
  } else if (type == "state" && json.contains("time") && json["time"].is_number()) {
    const double time = json["time"].get<double>();
    if (!record.times.empty() && time < record.times.back()) return false;
    record.times.push_back(time);
    record.states.push_back(line);
  } else if (type != "command") {
    return false;
  }
  return !record.hello.is_null();
}

std::optional<Record> read_record(const std::string& path, const std::string& checksum,
                                  Diagnostics& diagnostics) {
  const auto refuse = [&](int line, std::string fault, std::string remedy) {
    diagnostics.add({Severity::error, path, line, "", std::move(fault), std::move(remedy)});
    return std::nullopt;
  };
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return refuse(0, "cannot be read", "Name a file of `treeline drive --record`.");
  Record record;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (take_line(line, record)) continue;
    if (stream.eof() && !record.states.empty()) break;  // a drive that was killed in mid-line
    return refuse(number, "this is no line of a record",
                  "Give a file that `treeline drive --record` has written.");
  }
  if (record.states.empty()) {
    return refuse(0, "there is no state in it", "Record a drive that begins: --record FILE.");
  }
  if (record.hello.value("robot", "") != checksum) {
    return refuse(1, "this was recorded with another URDF or scene",
                  "Give the files that it was recorded with, unchanged.");
  }
  return record;
}

/// What a front end hears first: a robot that it may only watch.
std::string greeting(Record& record, const PageSettings& page) {
  Json meshes = Json::object();
  Json missing = Json::array();
  for (std::size_t i = 0; i < page.meshes.size(); ++i) {
    if (page.meshes[i].path.empty()) {
      missing.push_back(page.meshes[i].uri);
    } else {
      meshes[page.meshes[i].uri] = "/mesh/" + std::to_string(i);
    }
  }
  record.hello["may_command"] = false;
  record.hello["replay"] = true;
  record.hello["meshes"] = meshes;
  record.hello["missing_meshes"] = missing;
  return record.hello.dump();
}

drive::ServerHandlers make_handlers(const std::string& hello, std::atomic<int>& last) {
  drive::ServerHandlers handlers;
  handlers.join = [&hello, &last](bool, std::string& text) {
    text = hello;
    return ++last;
  };
  handlers.receive = [](int, std::string_view message) {
    const Json json = Json::parse(message.begin(), message.end(), nullptr, false);
    std::optional<std::int64_t> seq;
    if (json.is_object() && json.contains("seq") && json["seq"].is_number_integer()) {
      seq = json["seq"].get<std::int64_t>();
    }
    return drive::print_reply(seq, {false, "this is a record: nothing can be commanded", -1});
  };
  handlers.leave = [](int) {};
  return handlers;
}

void play(const Record& record, drive::Server& server) {
  constexpr auto kInterval = 33ms;
  constexpr double kPause = 1.0;  // s, before it begins again
  const auto begin = std::chrono::steady_clock::now();
  const double length = record.times.back() - record.times.front();
  for (std::int64_t seq = 1; !asked_to_close; ++seq) {
    const double passed =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const double time = record.times.front() + std::min(length, std::fmod(passed, length + kPause));
    const auto after = std::upper_bound(record.times.begin(), record.times.end(), time);
    const auto row =
        static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - record.times.begin() - 1));
    Json state = Json::parse(record.states[row]);
    state["seq"] = seq;
    state["watchers"] = server.connections();
    state["commanding"] = false;
    server.send_states([text = state.dump()](int) { return text; });
    std::this_thread::sleep_for(kInterval);
  }
}

}  // namespace

bool replay(const std::string& path, const std::string& checksum, const PageSettings& page,
            Diagnostics& diagnostics) {
  auto record = read_record(path, checksum, diagnostics);
  if (!record) return false;
  const std::string hello = greeting(*record, page);
  std::atomic<int> last{0};
  asked_to_close = false;
  answer_signals([] { asked_to_close = true; });
  const auto server = serve_page(page, make_handlers(hello, last), diagnostics);
  if (server) play(*record, *server);
  answer_signals(nullptr);
  return server != nullptr;
}

}  // namespace treeline
