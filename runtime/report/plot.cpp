#include "report/plot.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "report/svg.hpp"
#include "report/ticks.hpp"

namespace treeline::report {
namespace {

// Layout in pixels.
constexpr double kLeft = 84.0;
constexpr double kPlotWidth = 660.0;
constexpr double kTop = 66.0;
constexpr double kPanelHeight = 150.0;
constexpr double kPathHeight = 330.0;
constexpr double kPathGap = 76.0;  // below a path, for the labels of its own x axis
constexpr double kGap = 42.0;
constexpr double kBottom = 56.0;
constexpr double kSample = 24.0;    // length of a line in the legend
constexpr double kCharacter = 6.9;  // upper estimate of the width of a letter

/// Colours of Okabe and Ito, which colour-blind readers can distinguish.
constexpr std::array kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                 "#e69f00", "#56b4e9", "#7f7f7f"};

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void take(double value) {
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  double span() const { return high - low; }
};

/// Place of a panel on the page, and the ranges of its numbers.
struct Frame {
  Range x;
  Range y;
  double top = 0.0;
  double height = kPanelHeight;
  double width = kPlotWidth;
  double column(double value) const { return kLeft + (value - x.low) / x.span() * width; }
  double row(double value) const { return top + (y.high - value) / y.span() * height; }
};

bool is_path(const PlotPanel& panel) {
  return !panel.path_x_label.empty();
}

double panel_height(const PlotPanel& panel) {
  return is_path(panel) ? kPathHeight : kPanelHeight;
}

/// Distance from a panel's bottom to the top of the next panel.
double gap_below(const PlotPanel& panel) {
  return is_path(panel) ? kPathGap : kGap;
}

/// Width of the legend on the right of the panels, for the longest name.
double legend_width(const Plot& plot) {
  std::size_t longest = 0;
  for (const PlotPanel& panel : plot.panels) {
    for (const PlotLine& line : panel.lines) {
      longest = std::max(longest, line.name.size());
    }
  }
  return 36.0 + kSample + kCharacter * static_cast<double>(longest);
}

Range x_range(const std::vector<double>& x) {
  Range range;
  for (const double value : x) {
    range.take(value);
  }
  if (!(range.span() > 0.0)) {
    range = {0.0, 1.0};
  }
  return range;
}

Range y_range(const PlotPanel& panel) {
  Range range;
  for (const PlotLine& line : panel.lines) {
    for (const double value : line.values) {
      range.take(value);
    }
  }
  if (!std::isfinite(range.span())) {
    range = {0.0, 1.0};
  }
  const double smallest = std::max({panel.least_span, 1e-12 * std::fabs(range.high), 1e-300});
  const double widen = std::max(0.0, smallest - range.span()) / 2.0;
  range = {range.low - widen, range.high + widen};
  const double margin = 0.06 * range.span();
  return {range.low - margin, range.high + margin};
}

/// Makes the panel a square with equal scales in both directions and the path in its middle.
void frame_path(const PlotPanel& panel, Frame& frame) {
  Range x;
  for (const PlotLine& line : panel.lines) {
    for (const double value : line.x) {
      x.take(value);
    }
  }
  const Range y = frame.y;
  frame.height = kPathHeight;
  frame.width = kPathHeight;
  if (!std::isfinite(x.span())) {
    frame.x = {0.0, 1.0};
    return;
  }
  const double half = 0.5 * std::max(1.12 * x.span(), y.span());
  const auto around = [half](const Range& range) {
    const double middle = 0.5 * (range.low + range.high);
    return Range{middle - half, middle + half};
  };
  frame.x = around(x);
  frame.y = around(y);
}

/// Indices of the points that determine the visible shape, in order: the first, the smallest and
/// the largest value of each pixel column, and the very last. Extremes at a column's ends need no
/// point of their own.
std::vector<std::size_t> thin(const Frame& frame, const std::vector<double>& x,
                              const std::vector<double>& y) {
  std::vector<std::size_t> kept;
  const std::size_t count = std::min(x.size(), y.size());
  for (std::size_t begin = 0; begin < count;) {
    const double column = std::floor(frame.column(x[begin]));
    std::size_t end = begin;
    std::size_t low = begin;
    std::size_t high = begin;
    for (; end < count && std::floor(frame.column(x[end])) == column; ++end) {
      low = y[end] < y[low] ? end : low;
      high = y[end] > y[high] ? end : high;
    }
    kept.push_back(begin);
    for (const std::size_t extreme : {std::min(low, high), std::max(low, high)}) {
      if (extreme > kept.back()) {
        kept.push_back(extreme);
      }
    }
    begin = end;
  }
  if (count > 0 && kept.back() + 1 < count) {
    kept.push_back(count - 1);
  }
  return kept;
}

std::string draw_curve(const Frame& frame, const std::vector<double>& x, const PlotLine& line,
                       const char* style) {
  std::string path;
  bool down = false;
  for (const std::size_t i : thin(frame, x, line.values)) {
    const bool finite = std::isfinite(line.values[i]);
    if (finite) {
      path += fmt::format("{}{:.2f} {:.2f}", down ? "L" : "M", frame.column(x[i]),
                          frame.row(line.values[i]));
    }
    down = finite;
  }
  return fmt::format("<path d=\"{}\" fill=\"none\" stroke-linejoin=\"round\" {}/>\n", path, style);
}

std::string line_style(const PlotLine& line, std::size_t solid_index) {
  if (line.dashed) {
    return "stroke=\"#222\" stroke-width=\"1\" stroke-dasharray=\"3 5\"";
  }
  return fmt::format("stroke=\"{}\" stroke-width=\"2.2\"", kColours[solid_index % kColours.size()]);
}

std::string draw_x_label(const Frame& frame, const std::string& label, double y) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                     kLeft + frame.width / 2.0, y, escape_xml(label));
}

std::string draw_axes(const Frame& frame, const PlotPanel& panel, bool with_x_labels) {
  const double right = kLeft + frame.width;
  const double bottom = frame.top + frame.height;
  std::string text;
  const Ticks vertical = round_ticks(frame.y.low, frame.y.high, 6);
  for (const double value : vertical.values) {
    const double row = frame.row(value);
    text += fmt::format(
        "<path d=\"M{:.1f} {:.2f}H{:.1f}\" stroke=\"#e4e4e4\"/>"
        "<text x=\"{:.1f}\" y=\"{:.2f}\" text-anchor=\"end\">{}</text>\n",
        kLeft, row, right, kLeft - 8.0, row + 4.0, tick_label(value, vertical.decimals));
  }
  const Ticks horizontal = round_ticks(frame.x.low, frame.x.high, is_path(panel) ? 6 : 11);
  for (const double value : horizontal.values) {
    const double column = frame.column(value);
    text += fmt::format("<path d=\"M{:.2f} {:.1f}V{:.1f}\" stroke=\"#e4e4e4\"/>", column, frame.top,
                        bottom);
    if (with_x_labels) {
      text += fmt::format("<text x=\"{:.2f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>",
                          column, bottom + 18.0, tick_label(value, horizontal.decimals));
    }
    text += '\n';
  }
  text += svg_frame(kLeft, frame.top, frame.width, frame.height, "#555");
  text += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-weight=\"600\">{}</text>\n"
      "<text transform=\"translate(22 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
      kLeft, frame.top - 9.0, escape_xml(panel.title), frame.top + frame.height / 2.0,
      escape_xml(panel.y_label));
  if (is_path(panel)) {
    text += draw_x_label(frame, panel.path_x_label, bottom + 38.0);
  }
  return text;
}

std::string draw_legend_entry(const Frame& frame, const PlotLine& line, const std::string& style,
                              std::size_t place) {
  const double x = kLeft + frame.width + 14.0;
  const double y = frame.top + 10.0 + 18.0 * static_cast<double>(place);
  return fmt::format(
      "<path d=\"M{:.1f} {:.1f}h{:.0f}\" {}/><text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x, y,
      kSample, style, x + kSample + 7.0, y + 4.0, escape_xml(line.name));
}

std::string draw_panel(const Frame& frame, const Plot& plot, const PlotPanel& panel, bool last) {
  std::string text = draw_axes(frame, panel, last || is_path(panel));
  std::string on_top;
  std::size_t solid_index = 0;
  std::size_t entries = 0;
  for (const PlotLine& line : panel.lines) {
    const std::string style = line_style(line, solid_index);
    solid_index += line.dashed ? 0 : 1;
    const std::vector<double>& x = is_path(panel) ? line.x : plot.x;
    (line.dashed ? on_top : text) += draw_curve(frame, x, line, style.c_str());
    if (!line.name.empty()) {
      on_top += draw_legend_entry(frame, line, style, entries++);
    }
  }
  return text + on_top;
}

}  // namespace

std::string svg_text(const Plot& plot) {
  double height = kTop + kBottom;
  for (const PlotPanel& panel : plot.panels) {
    height += panel_height(panel) + (&panel == &plot.panels.back() ? 0.0 : gap_below(panel));
  }
  std::string text =
      fmt::format("<text x=\"{:.1f}\" y=\"26\" font-size=\"15\" font-weight=\"600\">{}</text>\n",
                  kLeft, escape_xml(plot.title));
  Frame shared;
  shared.x = x_range(plot.x);
  shared.top = kTop;
  for (const PlotPanel& panel : plot.panels) {
    Frame frame = shared;
    frame.y = y_range(panel);
    if (is_path(panel)) {
      frame_path(panel, frame);
    }
    text += draw_panel(frame, plot, panel, &panel == &plot.panels.back());
    shared.top += frame.height + gap_below(panel);
  }
  text += draw_x_label(shared, plot.x_label, height - 14.0);
  return svg_page(kLeft + kPlotWidth + legend_width(plot), height,
                  "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\" fill=\"#222\"",
                  text, "#fff");
}

}  // namespace treeline::report
