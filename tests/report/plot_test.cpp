// Ticks computed by hand, the plot's XML read by a parser, the table's text read back. Would catch:
// ticks at numbers that are not round, XML that is broken by a name, thinning that loses a peak,
// and digits lost in CSV.
#include "report/plot.hpp"

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "report/table.hpp"
#include "report/ticks.hpp"

namespace {

using namespace treeline::report;  // NOLINT: all of it is under test

TEST(Ticks, AreRound) {
  const Ticks ticks = round_ticks(-0.013, 0.27, 6);
  ASSERT_EQ(ticks.values.size(), 3U);
  EXPECT_EQ(ticks.values[0], 0.0);
  EXPECT_EQ(ticks.values[1], 0.1);
  EXPECT_EQ(ticks.decimals, 1);
  EXPECT_EQ(tick_label(-0.25, 2), "\u22120.25");
  EXPECT_EQ(tick_label(-1e-18, 1), "0.0");
  EXPECT_EQ(tick_label(-2e-7, 7), "\u22122e-07");
  EXPECT_EQ(tick_label(0.0, 7), "0");
}

TEST(Ticks, StayWithinTheirNumberAndRange) {
  for (double span = 1e-9; span < 1e9; span *= 1.37) {
    for (const double low : {-0.3 * span, 0.0, 17.0 * span}) {
      const Ticks ticks = round_ticks(low, low + span, 6);
      EXPECT_GE(ticks.values.size(), 2U) << span;
      EXPECT_LE(ticks.values.size(), 7U) << span;
      EXPECT_GE(ticks.values.front(), low - 1e-6 * span);
      EXPECT_LE(ticks.values.back(), low + span * (1.0 + 1e-6));
    }
  }
}

Plot sample_plot() {
  Plot plot;
  plot.title = "a < b & c";
  plot.x_label = "time (s)";
  PlotLine line{"<name>", {}, false};
  for (int i = 0; i < 100000; ++i) {
    plot.x.push_back(i * 1e-4);
    line.values.push_back(i == 54321 ? 10.0 : std::sin(i * 1e-4));
  }
  line.values[70000] = std::nan("");
  plot.panels = {{"one", "m", {line, {"wanted", line.values, true}}, 0.0}, {"none", "m", {}, 1.0}};
  return plot;
}

// Every other sample in a pixel column of 2.x samples is its last one: at each place a peak must
// stay.
TEST(Plot, KeepsAPeakWhereverItIsInItsPixelColumn) {
  for (int at = 700; at < 712; ++at) {
    Plot plot;
    PlotLine line{"", {}, false};
    for (int i = 0; i < 1500; ++i) {
      plot.x.push_back(i * 1e-3);
      line.values.push_back(i == at ? 1.0 : 0.0);
    }
    plot.panels = {{"one", "N", {line}, 0.0}};
    const double row = 66.0 + 150.0 * (0.06 / 1.12);
    std::ostringstream top;
    top.precision(2);
    top << std::fixed << " " << row;
    EXPECT_NE(svg_text(plot).find(top.str()), std::string::npos) << at;
  }
}

TEST(Plot, IsWellFormedThinnedAndKeepsPeaks) {
  const std::string svg = svg_text(sample_plot());
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(svg.c_str()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  EXPECT_LT(svg.size(), 200000U);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  // The single sample at 10 is the top of the first panel: 6 % of the span below its frame.
  const double row = 66.0 + 150.0 * (0.06 / 1.12);
  std::ostringstream top;
  top.precision(2);
  top << std::fixed << " " << row;
  EXPECT_NE(svg.find(top.str()), std::string::npos);
}

TEST(Table, ReadsBackTheSameNumbersAndRefusesMoreThanItHolds) {
  Table table({"time", "x"}, 2);
  const double first[2] = {0.1, 1.0 / 3.0};
  const double second[2] = {-0.0, 1e-300};
  EXPECT_TRUE(table.append(first));
  EXPECT_TRUE(table.append(second));
  EXPECT_FALSE(table.append(first));
  EXPECT_EQ(table.rows(), 2U);
  const std::string text = csv_text(table);
  EXPECT_EQ(text.substr(0, 7), "time,x\n");
  const std::size_t comma = text.find(',', 7);
  EXPECT_EQ(std::strtod(text.c_str() + comma + 1, nullptr), 1.0 / 3.0);
  EXPECT_EQ(table.column(1)[1], 1e-300);
}

TEST(Table, SaysWhyItCannotWrite) {
  EXPECT_NE(write_text("/nonexistent/file.csv", "x").find("No such file"), std::string::npos);
}

// A circle is drawn round: equal scales in both directions, over its own abscissae.
TEST(Plot, DrawsAPathWithOneScale) {
  Plot plot = sample_plot();
  PlotLine circle{"circle", {}, false, {}};
  for (int i = 0; i <= 360; ++i) {
    circle.x.push_back(7.0 + 0.2 * std::cos(i * 0.0174532925));
    circle.values.push_back(-3.0 + 0.2 * std::sin(i * 0.0174532925));
  }
  plot.panels = {{"path", "z (m)", {circle}, 0.0, "y (m)"}};
  const std::string text = svg_text(plot);
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(text.c_str()), tinyxml2::XML_SUCCESS);
  EXPECT_NE(text.find(">y (m)<"), std::string::npos);
  const std::size_t at = text.find("fill=\"none\" stroke-linejoin");
  ASSERT_NE(at, std::string::npos);
  std::istringstream path(text.substr(text.rfind("d=\"", at) + 3));
  double least[2] = {1e9, 1e9};
  double most[2] = {-1e9, -1e9};
  char command = 0;
  for (double point[2]; path >> command >> point[0] >> point[1];) {
    for (int i = 0; i < 2; ++i) {
      least[i] = std::fmin(least[i], point[i]);
      most[i] = std::fmax(most[i], point[i]);
    }
  }
  EXPECT_GT(most[0] - least[0], 200.0);  // pixels
  EXPECT_NEAR(most[0] - least[0], most[1] - least[1], 1.0);
}

}  // namespace
