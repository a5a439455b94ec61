#include <cstdio>
#include <filesystem>
#include <limits>

#include "count_growth.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"

// Writes, for each series, a table and a figure into a folder: growth_report FOLDER.

namespace {

using namespace treeline;  // NOLINT: a program of one file

report::PlotPanel panel_of(const growth::Series& series, std::size_t first_way, std::size_t ways,
                           const char* title) {
  report::PlotPanel panel{title, "flops", {}};
  for (std::size_t k = first_way; k < first_way + ways; ++k) {
    report::PlotLine line{series.ways[k], {}};
    for (const int flops : series.flops[k]) {
      line.values.push_back(flops > 0 ? flops : std::numeric_limits<double>::quiet_NaN());
    }
    panel.lines.push_back(line);
  }
  return panel;
}

/// Draws all ways, and below them all except the last, which is much larger than the others.
report::Plot figure_of(const growth::Series& series) {
  report::Plot plot{"Operations: " + series.name, series.size, {}, {}};
  for (const int size : series.sizes) plot.x.push_back(size);
  plot.panels = {panel_of(series, 0, series.ways.size(), "all ways"),
                 panel_of(series, 0, series.ways.size() - 1, "without the last")};
  return plot;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: growth_report FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  for (const growth::Series& series : growth::count_all()) {
    std::printf("%s (%s)\n%s\n", series.name.c_str(), series.size.c_str(),
                growth::csv_text(series).c_str());
    const std::string stem = (folder / series.name).string();
    const std::string fault =
        report::write_text(stem + ".csv", growth::csv_text(series)) +
        report::write_text(stem + ".svg", report::svg_text(figure_of(series)));
    if (!fault.empty()) {
      std::fprintf(stderr, "%s\n", fault.c_str());
      return 1;
    }
  }
  return 0;
}
