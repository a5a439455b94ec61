#include "driving/latency.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

#include "drive/session.hpp"
#include "driving/loop_handle.hpp"
#include "driving/robot_elsewhere.hpp"
#include "interruption/clean_up.hpp"
#include "servo/realtime.hpp"
#include "terminal/write_output.hpp"

namespace treeline {
namespace {

using namespace std::chrono_literals;

std::atomic<bool> asked_to_finish{false};

/// Threads that keep processors and memory busy until they are destroyed.
class Load {
 public:
  explicit Load(int threads) {
    for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
  }
  ~Load() {
    ended_ = true;
    for (std::thread& thread : threads_) thread.join();
  }
  Load(const Load&) = delete;
  Load& operator=(const Load&) = delete;

 private:
  void work() {
    std::vector<double> memory(std::size_t{1} << 20U, 1.0);  // 8 MiB: more than a cache of a core
    while (!ended_) {
      for (double& number : memory) number = 0.999 * number + 0.001;
      sink_ = memory[0];
    }
  }
  std::atomic<bool> ended_{false};
  std::atomic<double> sink_{0};
  std::vector<std::thread> threads_;
};

/// Samples of the cycles in which the loop controls.
void take(const drive::ReportHead& head, LatencyReport& report) {
  constexpr double kMicro = 1e-3;
  if (head.control_time == 0) return;
  ++report.cycles;
  report.late += head.skipped > 0 ? 1 : 0;
  const std::int64_t values[] = {head.period, head.jitter, head.control_time};
  for (std::size_t i = 0; i < report.series.size(); ++i) {
    report.series[i].samples.push_back(static_cast<float>(kMicro * static_cast<double>(values[i])));
  }
}

void send(LoopHandle& loop, servo::MessageKind kind) {
  servo::Message message;
  message.kind = kind;
  loop.send(message);
}

/// Runs the loop in a thread of its own and collects its reports.
void run(LoopHandle& loop, drive::Session& session, const LatencySettings& settings,
         LatencyReport& report) {
  const Load load(settings.load);
  std::atomic<bool> ended{false};
  std::thread servo([&] {
    report.refused = servo::request_realtime();
    while (loop.step()) {
    }
    ended = true;
  });
  std::vector<double> numbers(static_cast<std::size_t>(session.layout().size));
  const auto begin = std::chrono::steady_clock::now();
  bool asked = false;
  send(loop, servo::MessageKind::start);
  while (!ended) {
    std::this_thread::sleep_for(4ms);
    drive::ReportHead head;
    while (loop.receive(head, numbers.data())) {
      session.take_report(head, numbers.data());
      if (!asked) take(head, report);
    }
    const double passed =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    report.fault = session.fault();
    const bool goes_on = passed < settings.seconds && !asked_to_finish && report.fault.empty();
    if (asked || goes_on) continue;
    asked = true;
    report.seconds = passed;
    send(loop, servo::MessageKind::disconnect);
  }
  servo.join();
}

}  // namespace

ExitCode measure_latency(const LaunchedRobot& robot, const DriveSettings& drive,
                         const LatencySettings& settings, Diagnostics& diagnostics) {
  const std::vector<double> start = start_of(robot, drive.start, diagnostics);
  if (start.empty()) return kBadInput;
  LoopHandle loop(robot.library.functions(), robot.description,
                  {drive.rate, true, start, {}, drive.simulation.options(), {}, {}});
  drive::Session session(robot.description, drive.rate, false,
                         [&loop](const servo::Message& message) { return loop.send(message); });
  LatencyReport report;
  report.robot = robot.description.name;
  report.rate = drive.rate;
  report.load_threads = settings.load;
  report.series = {{"period", {}}, {"jitter", {}}, {"control", {}}};
  for (LatencySeries& series : report.series) {
    series.samples.reserve(static_cast<std::size_t>(settings.seconds * drive.rate) + 1000);
  }
  asked_to_finish = false;
  answer_signals([] { asked_to_finish = true; });
  run(loop, session, settings, report);
  answer_signals(nullptr);
  getloadavg(&report.load_average, 1);
  const ExitCode exit_code =
      write_output(print_text(report), OutputForm::text, report.fault.empty() ? kOk : kMismatch);
  if (settings.report.empty()) return exit_code;
  const bool written =
      write_output_file(settings.report + ".json", print_json(report), diagnostics) &&
      write_output_file(settings.report + ".svg", print_svg(report), diagnostics);
  return written ? exit_code : kBadInput;
}

}  // namespace treeline
