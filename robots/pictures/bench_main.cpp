// Draws time against error from a report of `treeline bench`. Exit status: 0 drawn, 1 bad input, 2
// usage.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <fstream>

#include "draw_bench.hpp"

int main(int argc, char** argv) {
  using namespace treeline;  // NOLINT: a program, not a header
  CLI::App app{"Draw time against error from a report of `treeline bench`, as SVG"};
  std::string report;
  std::string svg;
  std::vector<std::string> functions;
  app.add_option("report", report, "what treeline bench printed")->required();
  app.add_option("--svg", svg, "file to write")->required();
  app.add_option("--functions", functions, "a panel each")->delimiter(',')->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  std::string error;
  const pictures::BenchReport read = pictures::read_bench(report, error);
  const std::string text = error.empty() ? pictures::draw_bench(read, functions, error) : "";
  if (error.empty()) {
    std::ofstream file(svg, std::ios::binary);
    file << text << std::flush;
    if (!file) error = svg + ": cannot be written";
  }
  if (!error.empty()) fmt::print(stderr, "draw_bench: {}\n", error);
  return error.empty() ? 0 : 1;
}
