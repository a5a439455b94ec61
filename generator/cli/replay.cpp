#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <vector>

#include "cli/record.hpp"
#include "interruption/clean_up.hpp"
#include "text/json_text.hpp"

namespace treeline {
namespace {

using Json = nlohmann::ordered_json;
using namespace std::chrono_literals;

std::atomic<bool> asked_to_close{false};

/// First message to a front end: a robot that it may only watch.
std::string greeting(const Record& record, const PageSettings& page,
                     const drive::NewFrontEnd& joined) {
  Json hello = Json::parse(record.hello);
  hello["may_command"] = false;
  hello["replay"] = true;
  hello.update(
      Json::parse(drive::print_meshes(page.meshes, joined.mesh_query, joined.may_command)));
  return json_line(hello);
}

drive::ServerHandlers make_handlers(const Record& record, const PageSettings& page,
                                    std::atomic<int>& last) {
  drive::ServerHandlers handlers;
  handlers.join = [&](const drive::NewFrontEnd& joined, std::string& hello) {
    hello = greeting(record, page, joined);
    return ++last;
  };
  handlers.receive = [](int, std::string_view message) {
    const Json json = Json::parse(message.begin(), message.end(), nullptr, false);
    std::optional<std::int64_t> seq;
    if (json.is_object() && json.contains("seq") && json["seq"].is_number_integer()) {
      seq = json["seq"].get<std::int64_t>();
    }
    return drive::print_reply(seq,
                              {false, "this is a recorded motion: nothing can be commanded", -1});
  };
  handlers.leave = [](int) {};
  return handlers;
}

/// Begins when the first front end looks, so that its picture is placed about the beginning.
void play(const Record& record, drive::Server& server) {
  constexpr auto kInterval = 33ms;
  constexpr double kPause = 1.0;  // s, before it begins again
  auto begin = std::chrono::steady_clock::now();
  const double length = record.times.back() - record.times.front();
  for (std::int64_t seq = 1; !asked_to_close; ++seq) {
    if (server.connections() == 0) begin = std::chrono::steady_clock::now();
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
    server.send_states([text = json_line(state)](int) { return text; });
    std::this_thread::sleep_for(kInterval);
  }
}

}  // namespace

bool replay(const Record& record, const PageSettings& page, Diagnostics& diagnostics) {
  std::atomic<int> last{0};
  asked_to_close = false;
  answer_signals([] { asked_to_close = true; });
  const auto server = serve_page(page, make_handlers(record, page, last), diagnostics);
  if (server) play(record, *server);
  answer_signals(nullptr);
  return server != nullptr;
}

}  // namespace treeline
