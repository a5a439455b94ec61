#include "bench/draw_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include "report/decades.hpp"
#include "report/svg.hpp"

namespace treeline {
namespace {

using report::Decades;
using report::decades_of;
using report::escape_xml;
using report::svg_line;
using report::svg_text_at;
using report::time_name;

constexpr double kPanelWidth = 460, kPanelHeight = 330;
constexpr double kLeft = 58, kRight = 16, kTop = 26, kBottom = 42;  ///< margins in a panel
constexpr double kHead = 104;
constexpr int kColumns = 3;
/// Exact results are drawn at the bottom, results that are not numbers at the top.
constexpr double kLeastError = 1e-18, kGreatestError = 1e2;

struct Style {
  VariantGroup group;
  std::string_view legend;
  const char* color;
  const char* path;  ///< outline of the mark around the origin
  bool filled;
};
constexpr const char* kCircle = "M-4,0a4,4 0 1,0 8,0a4,4 0 1,0 -8,0z";
constexpr const char* kSquare = "M-3.5,-3.5h7v7h-7z";
constexpr const char* kDiamond = "M0,-5l5,5l-5,5l-5,-5z";
constexpr const char* kUp = "M0,-4.5l4.5,8h-9z";
constexpr const char* kDown = "M0,4.5l4.5,-8h-9z";
constexpr const char* kCross = "M-4,-4l8,8m0,-8l-8,8";
constexpr const char* kPlus = "M-4.5,0h9m-4.5,-4.5v9";
constexpr const char* kStar =
    "M0,-6l1.6,3.8l4.1,0.3l-3.1,2.7l1,4l-3.6,-2.2l-3.6,2.2l1,-4l-3.1,-2.7l4.1,-0.3z";
constexpr std::array kStyles = {
    Style{VariantGroup::emitted, "as the scene asks", "#000000", kCircle, true},
    Style{VariantGroup::language, "C99", "#000000", kDiamond, false},
    Style{VariantGroup::batch, "8 states a call", "#17a2b8", kUp, true},
    Style{VariantGroup::lanes, "other lanes", "#1f77b4", kCircle, false},
    Style{VariantGroup::real, "other Real", "#2ca02c", kUp, false},
    Style{VariantGroup::route, "other route", "#ff7f0e", kSquare, false},
    Style{VariantGroup::inertia, "full inertias", "#8c564b", kDiamond, false},
    Style{VariantGroup::accuracy, "other accuracy", "#9467bd", kPlus, false},
    Style{VariantGroup::contraction, "not contracted", "#555555", kCross, false},
    Style{VariantGroup::sines, "other sines", "#17a2b8", kDown, false},
    Style{VariantGroup::solve, "Eigen's factorisations", "#d62728", kSquare, true},
    Style{VariantGroup::interpreter, "interpreter", "#e377c2", kDiamond, true}};

/// Colours of peers, used in turn.
constexpr std::array kPeerColors = {"#0b7a75", "#b8860b", "#c2185b", "#5d3fd3"};

/// Styles of the report's variants, in the order of the legend. Each peer has a style of its own.
class Styles {
 public:
  explicit Styles(const BenchReport& report) : used_(kStyles.begin(), kStyles.end()) {
    std::set<VariantGroup> groups;
    for (const BenchFunction& function : report.functions) {
      for (const BenchRow& row : function.rows) groups.insert(row.variant.group);
    }
    std::erase_if(used_, [&](const Style& style) { return !groups.contains(style.group); });
    for (const BenchPeer& peer : report.peers) {
      const char* const color = kPeerColors[peers_++ % kPeerColors.size()];
      used_.push_back({VariantGroup::peer, peer.name, color, kStar, true});
    }
  }

  [[nodiscard]] const std::vector<Style>& used() const { return used_; }
  [[nodiscard]] const Style& of(const Variant& variant) const {
    return *std::find_if(used_.begin(), used_.end(), [&](const Style& style) {
      return style.group == variant.group &&
             (variant.group != VariantGroup::peer || is_of(style.legend, variant.name));
    });
  }

 private:
  static bool is_of(std::string_view peer, std::string_view variant) {
    return variant == peer || (variant.starts_with(peer) && variant[peer.size()] == ',');
  }

  std::vector<Style> used_;
  std::size_t peers_ = 0;
};

std::string mark(const Style& style, double x, double y, const std::string& title) {
  return fmt::format(
      "<path d=\"{}\" transform=\"translate({:.1f},{:.1f})\" fill=\"{}\" stroke=\"{}\" "
      "stroke-width=\"1.5\"><title>{}</title></path>\n",
      style.path, x, y, style.filled ? style.color : "none", style.color, escape_xml(title));
}

std::string text_at(double x, double y, std::string_view text, std::string_view attributes) {
  return svg_text_at(x, y, attributes, escape_xml(text));
}

double error_of(const BenchRow& row) {
  return std::clamp(row.norm.worst, kLeastError, kGreatestError);
}

/// The part of a panel's error axis for one Real. Errors in float and double lie far apart with
/// nothing between them, so each has its own part.
struct Band {
  Decades decades;
  double top = 0, height = 1;
  [[nodiscard]] double y(double error) const { return top + height * (1 - decades.at(error)); }
};

class Panel {
 public:
  Panel(const BenchFunction& function, const Styles& styles, double x, double y)
      : function_(function), styles_(styles), x0_(x + kLeft), y0_(y + kTop) {
    std::vector<double> times;
    std::vector<double> errors;
    std::vector<double> single_errors;
    for (const BenchRow& row : function.rows) {
      times.push_back(row.timing.nanoseconds);
      (row.variant.real == Real::float32 ? single_errors : errors).push_back(error_of(row));
    }
    times_ = decades_of(times, 0);
    single_ = {decades_of(single_errors, 0), y0_, kSingleHeight};
    double_ = {decades_of(errors, 0.3), y0_ + kSingleHeight + kGap, kHeight - kSingleHeight - kGap};
  }

  [[nodiscard]] std::string draw() const {
    std::string text = text_at(x0_, y0_ - 8, function_name(function_.function),
                               "font-size=\"13\" font-weight=\"bold\"");
    return text + draw_axes() + draw_front() + draw_labels() + draw_marks();
  }

 private:
  static constexpr double kWidth = kPanelWidth - kLeft - kRight;
  static constexpr double kHeight = kPanelHeight - kTop - kBottom;
  static constexpr double kSingleHeight = 72;
  static constexpr double kGap = 14;

  [[nodiscard]] double x(double nanoseconds) const { return x0_ + kWidth * times_.at(nanoseconds); }
  [[nodiscard]] double y(const BenchRow& row) const {
    return (row.variant.real == Real::float32 ? single_ : double_).y(error_of(row));
  }

  [[nodiscard]] std::string draw_axes() const {
    std::string text;
    for (int decade = times_.first; decade <= times_.last; ++decade) {
      text += text_at(x(std::pow(10, decade)), y0_ + kHeight + 14, time_name(decade),
                      "text-anchor=\"middle\"");
    }
    return text + draw_band(single_) + draw_band(double_);
  }

  [[nodiscard]] std::string draw_band(const Band& band) const {
    std::string text;
    for (int decade = times_.first; decade < times_.last; ++decade) {
      for (const double part : {2.0, 5.0, 10.0}) {
        const double at = x(part * std::pow(10, decade));
        text +=
            svg_line(at, band.top, at, band.top + band.height, part < 10 ? "#f0f0f0" : "#d0d0d0");
      }
    }
    const Decades& decades = band.decades;
    const int step = 1 + static_cast<int>(14 * (decades.last - decades.first) / band.height);
    for (int decade = decades.first; decade <= decades.last; decade += step) {
      const double at = band.y(std::pow(10, decade));
      text += svg_line(x0_, at, x0_ + kWidth, at, "#d0d0d0");
      text += text_at(x0_ - 5, at + 3.5, fmt::format("1e{}", decade), "text-anchor=\"end\"");
    }
    return text + report::svg_frame(x0_, band.top, kWidth, band.height, "#808080");
  }

  [[nodiscard]] std::vector<const BenchRow*> front() const {
    std::vector<const BenchRow*> rows;
    for (const BenchRow& row : function_.rows) {
      if (row.on_front) rows.push_back(&row);
    }
    std::sort(rows.begin(), rows.end(), [](const BenchRow* a, const BenchRow* b) {
      return a->timing.nanoseconds < b->timing.nanoseconds;
    });
    return rows;
  }

  /// Draws the line through the rows for which no other row is faster and more accurate.
  [[nodiscard]] std::string draw_front() const {
    std::string points;
    double last_y = y0_;
    for (const BenchRow* row : front()) {
      const double at = x(row->timing.nanoseconds);
      points += fmt::format("{:.1f},{:.1f} ", at, last_y);
      last_y = y(*row);
      points += fmt::format("{:.1f},{:.1f} ", at, last_y);
    }
    points += fmt::format("{:.1f},{:.1f}", x0_ + kWidth, last_y);
    return fmt::format(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"#404040\" stroke-dasharray=\"4 3\"/>\n",
        points);
  }

  [[nodiscard]] std::string draw_marks() const {
    std::string text;
    for (auto row = function_.rows.rbegin(); row != function_.rows.rend(); ++row) {
      text += mark(styles_.of(row->variant), x(row->timing.nanoseconds), y(*row),
                   fmt::format("{}: {:.3g} ns, {:.1e}", row->variant.name, row->timing.nanoseconds,
                               row->norm.worst));
    }
    return text;
  }

  /// Draws the names of rows on the front below their marks, where there is space, without overlap.
  [[nodiscard]] std::string draw_labels() const {
    constexpr std::size_t kLongest = 44;
    constexpr double kLine = 11;
    constexpr double kLetter = 4.8;
    std::string text;
    double last_y = 0;
    for (const BenchRow* row : front()) {
      std::string name = row->variant.name.substr(0, kLongest);
      if (name.size() < row->variant.name.size()) name += "...";
      const double room = x0_ + kWidth - 4 - kLetter * static_cast<double>(name.size());
      const double from = std::max(x0_ + 4, std::min(x(row->timing.nanoseconds) - 4, room));
      const double height = std::max(y(*row) + 16, last_y + kLine);
      last_y = height;
      text += text_at(from, height, name,
                      "fill=\"#303030\" font-size=\"9\" stroke=\"white\" stroke-width=\"3\" "
                      "paint-order=\"stroke\"");
    }
    return text;
  }

  const BenchFunction& function_;
  const Styles& styles_;
  double x0_, y0_;
  Decades times_;
  Band single_, double_;
};

std::string name_peers(const BenchReport& report) {
  std::string text;
  for (const BenchPeer& peer : report.peers) {
    text += fmt::format("{} {} {}", text.empty() ? "; beside" : ",", peer.name, peer.release);
  }
  return text;
}

std::string draw_legend(const Styles& styles) {
  std::string text;
  double x = 20;
  for (const Style& style : styles.used()) {
    text += mark(style, x, kHead - 18, std::string(style.legend));
    text += text_at(x + 10, kHead - 14, style.legend, "font-size=\"11\"");
    x += 32 + 6.2 * static_cast<double>(style.legend.size());
  }
  return text;
}

}  // namespace

std::string draw_svg(const BenchReport& report) {
  const int count = static_cast<int>(report.functions.size());
  const int rows = (count + kColumns - 1) / kColumns;
  const double width = kPanelWidth * kColumns;
  const double height = kHead + kPanelHeight * rows;
  std::string text =
      text_at(14, 26, report.name + ": time of a call across, worst norm-wise error up",
              "font-size=\"18\" font-weight=\"bold\"");
  text += text_at(14, 46,
                  fmt::format("{} states against 50 digits; {}; {}{}", report.states,
                              report.machine.processor, report.machine.command, name_peers(report)),
                  "font-size=\"12\"");
  text += text_at(14, 64,
                  "errors of float in the upper band, of double in the lower; dashed: the front, "
                  "which nothing beats in both (sines given left out); its variants are named",
                  "font-size=\"12\"");
  const Styles styles(report);
  text += draw_legend(styles);
  for (int i = 0; i < count; ++i) {
    const int row = i / kColumns;
    const Panel panel(report.functions[static_cast<std::size_t>(i)], styles,
                      kPanelWidth * (i % kColumns), kHead + kPanelHeight * row);
    text += panel.draw();
  }
  return report::svg_page(width, height, "font-family=\"sans-serif\" font-size=\"10\"", text);
}

}  // namespace treeline
