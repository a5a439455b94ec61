#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "bench/suite.hpp"
#include "report/svg.hpp"

namespace treeline {
namespace {

using report::escape_xml;
using report::svg_disc;
using report::svg_line;
using report::svg_text_at;

constexpr double kSuiteWidth = 800, kSuiteLeft = 230, kSuiteRight = 24, kSuiteTop = 84;
constexpr double kRowHeight = 34, kDot = 5;
constexpr std::array kFactors = {0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0};
/// Okabe's and Ito's colours, of robots in the order of the suite; those beyond have squares.
constexpr std::array kColours = {"#0072b2", "#e69f00", "#009e73", "#d55e00",
                                 "#cc79a7", "#56b4e9", "#000000", "#999999"};

double x_of(double factor) {
  const double low = std::log(kFactors.front());
  const double high = std::log(kFactors.back());
  const double share = (std::log(factor) - low) / (high - low);
  return kSuiteLeft + std::clamp(share, 0.0, 1.0) * (kSuiteWidth - kSuiteLeft - kSuiteRight);
}

/// The mark of a robot, `title` where a pointer rests on it.
std::string draw_mark(double x, double y, std::size_t robot, const std::string& title = {}) {
  const std::string colour = kColours.at(robot % kColours.size());
  if (robot < kColours.size()) return svg_disc(x, y, kDot, colour, title);
  return fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" fill=\"{}\">"
      "<title>{}</title></rect>\n",
      x - kDot, y - kDot, 2 * kDot, 2 * kDot, colour, escape_xml(title));
}

std::string draw_grid(double bottom) {
  std::string text;
  for (const double factor : kFactors) {
    text += svg_line(x_of(factor), kSuiteTop, x_of(factor), bottom,
                     factor == 1 ? "#606060" : "#d8d8d8");
    text += svg_text_at(x_of(factor), bottom + 16, "text-anchor=\"middle\"",
                        fmt::format("{:g}", factor));
  }
  return text + svg_text_at((kSuiteLeft + kSuiteWidth - kSuiteRight) / 2, bottom + 34,
                            "text-anchor=\"middle\"", "times as long as the emitted code takes");
}

/// Names of the robots beside dots of their colours, four a line.
std::string draw_legend(const std::vector<std::string>& robots) {
  std::string text;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const double x = 16 + 185 * static_cast<double>(i % 4);
    const std::size_t line = i / 4;
    const double y = 34 + 16 * static_cast<double>(line);
    text += draw_mark(x, y - 4, i) + svg_text_at(x + 10, y, "", escape_xml(robots[i]));
  }
  return text;
}

}  // namespace

std::string draw_svg(const std::vector<BenchReport>& reports) {
  std::vector<std::string> robots;
  std::map<Function, std::vector<SuiteResult>> rows;
  for (const BenchReport& report : reports) robots.push_back(report.name);
  for (const SuiteResult& result : compare_to_best(reports)) {
    if (result.best != nullptr) rows[result.function].push_back(result);
  }
  const double bottom = kSuiteTop + kRowHeight * static_cast<double>(rows.size());
  std::string body = svg_text_at(16, 16, "font-size=\"14\" font-weight=\"bold\"",
                                 "The fastest of the other libraries") +
                     draw_legend(robots) + draw_grid(bottom);
  double y = kSuiteTop + kRowHeight / 2;
  for (const auto& [function, results] : rows) {
    body += svg_text_at(kSuiteLeft - 10, y + 4, "text-anchor=\"end\"", function_name(function));
    for (const SuiteResult& result : results) {
      const auto robot = std::find(robots.begin(), robots.end(), result.scene) - robots.begin();
      const double factor = result.best->timing.nanoseconds / result.emitted->timing.nanoseconds;
      body +=
          draw_mark(x_of(factor), y, static_cast<std::size_t>(robot),
                    fmt::format("{}, {}: {:.1f} times, {}", result.scene,
                                function_name(result.function), factor, result.best->variant.name));
    }
    y += kRowHeight;
  }
  return report::svg_page(kSuiteWidth, bottom + 48, "font-family=\"sans-serif\" font-size=\"12\"",
                          body);
}

}  // namespace treeline
