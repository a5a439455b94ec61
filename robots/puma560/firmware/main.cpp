// Runs the PUMA's firmware on this machine and on boards in QEMU, compares every bit that they
// stream, prints what a cycle takes, and draws the motion.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <fstream>

#include "report/plot.hpp"
#include "run_on_boards.hpp"

namespace {

using treeline::FirmwareRun;
using treeline::report::Plot;
using treeline::report::PlotPanel;

PlotPanel joints_panel(const std::vector<Record>& records, const char* title, const char* unit,
                       const float (Record::*numbers)[6]) {
  PlotPanel panel;
  panel.title = title;
  panel.y_label = unit;
  for (int i = 0; i < 6; ++i) {
    treeline::report::PlotLine line{fmt::format("joint{}", i + 1), {}, false, {}};
    for (const Record& record : records) line.values.push_back((record.*numbers)[i]);
    panel.lines.push_back(std::move(line));
  }
  return panel;
}

std::string draw(const std::vector<Record>& records) {
  Plot plot;
  plot.title = "PUMA 560: the float controller on a Cortex-M4F in QEMU";
  plot.x_label = "time, s";
  for (const Record& record : records) plot.x.push_back(1e-3 * record.tick);
  plot.panels = {joints_panel(records, "Joint angles", "rad", &Record::q),
                 joints_panel(records, "Torques", "N m", &Record::tau)};
  PlotPanel mode;
  mode.title = "Mode: 0 idle, 1 running, 2 stopping, 3 faulted";
  mode.y_label = "mode";
  mode.lines.push_back({"", {}, false, {}});
  for (const Record& record : records) mode.lines[0].values.push_back(record.mode);
  plot.panels.push_back(std::move(mode));
  return treeline::report::svg_text(plot);
}

/// Every tenth record, as many as a page can show.
std::vector<Record> thin(const std::vector<Record>& records) {
  std::vector<Record> some;
  for (const Record& record : records) {
    if (record.tick % 10 == 0) some.push_back(record);
  }
  return some;
}

int fail(const treeline::Diagnostics& diagnostics) {
  for (const treeline::Diagnostic& each : diagnostics.list())
    fmt::print(stderr, "{}\n", to_string(each));
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Runs the PUMA's firmware on this machine and on boards in QEMU."};
  treeline::FirmwareSources sources;
  std::string compiler, svg;
  std::vector<std::string> targets = {"cortex-m4f", "cortex-m7", "rv32imfc"};
  app.add_option("--generated", sources.generated, "folder of the generated code")->required();
  app.add_option("--runtime", sources.runtime, "folder runtime/")->required();
  app.add_option("--own", sources.own, "folder of the firmware's sources")->required();
  app.add_option("--compiler", compiler, "of this machine")->required();
  app.add_option("--targets", targets, "processors, see treeline help generate");
  app.add_option("--svg", svg, "where to draw the motion");
  CLI11_PARSE(app, argc, argv);
  treeline::Diagnostics diagnostics;
  const auto host = run_on_host(compiler, sources, diagnostics);
  if (!host) return fail(diagnostics);
  int result = 0;
  fmt::print(
      "| processor | bits | instructions of a cycle | RAM of the loop | stack |\n"
      "|---|---|---|---|---|\n");
  for (const std::string& target : targets) {
    const auto board = run_on_board(target, sources, diagnostics);
    if (!board) return fail(diagnostics);
    const bool same = board->states == host->states;
    fmt::print("| {} | {} | {} to {} | {} bytes | {} bytes |\n", target,
               same ? "the host's" : "DIFFERENT", board->least, board->most, board->servo_bytes,
               board->stack);
    result = same && board->servo_bytes + board->stack <= 4096 ? result : 1;
  }
  if (!svg.empty()) std::ofstream(svg) << draw(thin(read_records(*host)));
  return result;
}
