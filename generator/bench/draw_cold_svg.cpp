#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/cold_report.hpp"
#include "report/decades.hpp"
#include "report/svg.hpp"
#include "report/ticks.hpp"

namespace treeline {
namespace {

using report::Decades;
using report::escape_xml;
using report::svg_disc;
using report::svg_line;
using report::svg_text_at;

constexpr double kColdWidth = 330, kColdHeight = 260;
constexpr double kColdLeft = 56, kColdRight = 18, kColdTop = 28,
                 kColdBottom = 44;  ///< margins in a panel
constexpr double kColdHead = 92;
constexpr double kMark = 4.5;  ///< radius
constexpr int kColdColumns = 3;

/// How a call finds its code.
struct Place {
  const char* legend;
  const char* colour;  ///< of Okabe and Ito
};
constexpr std::array kPlaces = {Place{"warm", "#009e73"}, Place{"from the shared cache", "#e69f00"},
                                Place{"from memory", "#d55e00"}};

/// Times of a row, in the order of `kPlaces`; those that were measured.
std::vector<double> times_of(const ColdRow& row) {
  std::vector<double> times{row.warm.nanoseconds, row.cold.from_cache.nanoseconds};
  if (row.cold.from_memory) times.push_back(row.cold.from_memory->nanoseconds);
  for (double& time : times) time = std::max(time, 0.1);
  return times;
}

class ColdPanel {
 public:
  ColdPanel(const ColdFunction& function, double x, double y)
      : function_(function), x0_(x + kColdLeft), y0_(y + kColdTop) {
    std::vector<double> times;
    for (const ColdRow& row : function.rows) {
      for (const double time : times_of(row)) times.push_back(time);
      most_bytes_ = std::max(most_bytes_, 1.15 * row.bytes.value_or(0));
    }
    times_ = report::decades_of(times);
  }

  std::string draw() {
    std::string text = svg_text_at(x0_, y0_ - 9, "font-size=\"13\" font-weight=\"bold\"",
                                   function_name(function_.function));
    text += draw_times() + draw_bytes();
    text += report::svg_frame(x0_, y0_, kWidth, kHeight, "#808080");
    for (const ColdRow& row : function_.rows) text += draw_row(row);
    return text;
  }

 private:
  static constexpr double kWidth = kColdWidth - kColdLeft - kColdRight;
  static constexpr double kHeight = kColdHeight - kColdTop - kColdBottom;

  [[nodiscard]] double x(double bytes) const { return x0_ + kWidth * bytes / most_bytes_; }
  [[nodiscard]] double y(double nanoseconds) const {
    return y0_ + kHeight * (1 - times_.at(nanoseconds));
  }

  [[nodiscard]] std::string draw_times() const {
    std::string text;
    for (int decade = times_.first; decade <= times_.last; ++decade) {
      for (const double part : {1.0, 2.0, 5.0}) {
        if (decade == times_.last && part > 1) continue;
        const double at = y(part * std::pow(10.0, decade));
        text += svg_line(x0_, at, x0_ + kWidth, at, part > 1 ? "#f0f0f0" : "#d0d0d0");
      }
      text += svg_text_at(x0_ - 5, y(std::pow(10.0, decade)) + 3.5, "text-anchor=\"end\"",
                          report::time_name(decade));
    }
    return text;
  }

  [[nodiscard]] std::string draw_bytes() const {
    std::string text;
    const report::Ticks ticks = report::round_ticks(0, most_bytes_ / 1000, 6);
    for (const double kilobytes : ticks.values) {
      const double at = x(1000 * kilobytes);
      text += svg_line(at, y0_, at, y0_ + kHeight, "#e8e8e8");
      text += svg_text_at(at, y0_ + kHeight + 14, "text-anchor=\"middle\"",
                          report::tick_label(kilobytes, ticks.decimals));
    }
    return text + svg_text_at(x0_ + kWidth / 2, y0_ + kHeight + 30, "text-anchor=\"middle\"",
                              "kB of code and constants");
  }

  /// One code: its times above each other, its name at the slowest.
  std::string draw_row(const ColdRow& row) {
    const std::vector<double> times = times_of(row);
    const double at = x(row.bytes.value_or(0));
    const auto [fastest, slowest] = std::minmax_element(times.begin(), times.end());
    std::string text = svg_line(at, y(*fastest), at, y(*slowest), "#9a9a9a");
    for (std::size_t i = 0; i < times.size(); ++i) {
      text += svg_disc(at, y(times[i]), kMark, kPlaces[i].colour,
                       fmt::format("{}, {}: {:.3g} ns, {} bytes; {}", names_of(row),
                                   kPlaces[i].legend, times[i], row.bytes.value_or(0), row.method));
    }
    return text + draw_name(row, at, y(*slowest));
  }

  /// The name beside the slowest mark, below those that stand there already.
  std::string draw_name(const ColdRow& row, double at, double height) {
    constexpr double kLine = 12;
    for (const double other : names_) {
      if (std::abs(height - other) < kLine) height = other + kLine;
    }
    names_.push_back(height);
    const bool right = at > x0_ + 0.6 * kWidth;
    return svg_text_at(at + (right ? -9 : 9), height + 3.5,
                       right ? "text-anchor=\"end\"" : "text-anchor=\"start\"", names_of(row));
  }

  const ColdFunction& function_;
  double x0_, y0_;
  double most_bytes_ = 100;
  Decades times_;
  std::vector<double> names_ = {};  ///< heights of those that are drawn
};

std::string draw_places() {
  std::string text;
  double x = 20;
  for (const Place& place : kPlaces) {
    text += svg_disc(x, kColdHead - 22, kMark, place.colour);
    text += svg_text_at(x + 10, kColdHead - 18, "font-size=\"11\"", place.legend);
    x += 40 + 6.2 * static_cast<double>(std::string_view(place.legend).size());
  }
  return text;
}

}  // namespace

std::string draw_svg(const ColdReport& report) {
  const int count = static_cast<int>(report.functions.size());
  const int columns = std::clamp(count, 2, kColdColumns);
  const int rows = (count + columns - 1) / columns;
  std::string text = svg_text_at(14, 26, "font-size=\"18\" font-weight=\"bold\"",
                                 escape_xml(report.name) + ": bytes across, time of a call up");
  text += svg_text_at(14, 46, "font-size=\"12\"",
                      escape_xml(fmt::format("{}; {}", report.machine.processor, report.flags)));
  text += draw_places();
  for (int i = 0; i < count; ++i) {
    const int row = i / columns;
    ColdPanel panel(report.functions[static_cast<std::size_t>(i)], kColdWidth * (i % columns),
                    kColdHead + kColdHeight * row);
    text += panel.draw();
  }
  return report::svg_page(kColdWidth * columns, kColdHead + kColdHeight * rows,
                          "font-family=\"sans-serif\" font-size=\"10\"", text);
}

}  // namespace treeline
